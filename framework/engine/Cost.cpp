#include "engine/Cost.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/Interrupts.h"
#include "engine/LowDiscrepancy.h"
#include "engine/SpecularTransport.h"
#include "engine/Visibility.h"

namespace radlab::engine {

namespace {

// Seconds on machine A of BENCHMARKS.md, both cores busy, 2026-11-23, fitted to cornell_1, cornell_2, furnace, l_room and
// teapot with 1,000 to 5,700 patches.
namespace unit {

struct Exact {
    double tolerance, facing, touching;  // seconds for a pair that faces, and more for one that touches
};
constexpr std::array<Exact, 5> exact{{{1e-12, 9.7e-7, 3.3e-4},
                                      {1e-9, 4.4e-7, 1.2e-4},
                                      {1e-6, 1.2e-7, 6.3e-5},
                                      {1e-4, 7.2e-8, 4.7e-5},
                                      {1e-2, 6.5e-8, 2.7e-5}}};
constexpr double point = 1.5e-8, polygon = 2.6e-7;  // for a pair, both ways
constexpr double shaft = 4e-8, shaftRay = 6e-8;     // for a pair; for a shadow ray
constexpr double hemisphereRay = 1.3e-7, specularRay = 1.6e-7;
constexpr double hemicubePatch = 4.8e-8, hemicubePixel = 4e-9;  // for each patch drawn into one; of size² pixels
constexpr double pass = 6.3e-10;                                // for an entry of the matrix
constexpr double cameraRay = 7e-8, pixelOut = 2e-7;             // to find a point; to tone map and write it
constexpr double smoothPatch = 2e-7;                            // to interpolate from patches to vertices

}  // namespace unit

// Taken for granted, not measured.
constexpr double iterations = 15.0;                          // to 1e-10 at usual reflectances
constexpr double raysPerGather = 16.0;                       // from a point that mirrors or is clear
constexpr double shareOfEdges = 0.1, samplesOnEdges = 15.0;  // pixels that differ from neighbours, and their samples
constexpr double bytesOfNodes = 1024.0, bytesOfPatch = 600.0, bytesOfPixel = 16.0, bytesOfSpecular = 16.0;

std::size_t indexAt(double share, std::size_t count) {
    return std::min(static_cast<std::size_t>(share * static_cast<double>(count)), count - 1);
}

// Goes through the rows of some patches, as many as a few million pairs allow.
void countPairs(const std::vector<Polygon>& patches, Work& work) {
    constexpr std::size_t mostPairs = std::size_t{1} << 21;
    const std::size_t count = patches.size();
    const std::size_t rows = std::clamp<std::size_t>(mostPairs / count, 1, count);
    const LowDiscrepancy points(0);
    for (std::size_t k = 0; k < rows; ++k) {
        Interrupts::check();
        const std::size_t i = rows == count ? k : indexAt(points.at(k)[0], count);
        for (const Polygon& other : patches) {
            if (&other == &patches[i] || !faceEachOther(patches[i], other)) continue;
            ++work.facing;
            if (glm::length(other.center - patches[i].center) < other.radius + patches[i].radius) ++work.touching;
        }
    }
    const double all = static_cast<double>(count) / static_cast<double>(rows) / 2.0;
    work.facing *= all;
    work.touching *= all;
}

double raysPerPair(const Geometry& geometry, std::size_t mostRays) {
    constexpr std::size_t pairs = 4096;
    const std::size_t count = geometry.patches.size();
    const Visibility visibility(geometry, mostRays);
    const LowDiscrepancy points(1);
    double facing = 0.0;
    for (std::size_t k = 0; k < pairs; ++k) {
        const auto at = points.at(k);
        Interrupts::check();
        const std::size_t i = indexAt(at[0], count), j = indexAt(at[1], count);
        if (i == j || !faceEachOther(geometry.patches[i], geometry.patches[j])) continue;
        ++facing;
        visibility.visibleShare(i, j);
    }
    return facing > 0.0 ? static_cast<double>(visibility.rays()) / facing : 0.0;
}

template <class Counts>
double shareOfArea(const Scene& scene, const Geometry& geometry, const Counts& counts) {
    double all = 0.0, some = 0.0;
    for (std::size_t i = 0; i < geometry.faces.size(); ++i) {
        all += geometry.faces[i].area;
        if (counts(*scene.faces[i].material)) some += geometry.faces[i].area;
    }
    return all > 0.0 ? some / all : 0.0;
}

double exactSeconds(const Work& work) {
    const double tolerance =
        std::clamp(work.options.tolerance, unit::exact.front().tolerance, unit::exact.back().tolerance);
    const auto above = std::find_if(unit::exact.begin() + 1, unit::exact.end() - 1,
                                    [=](const unit::Exact& one) { return one.tolerance >= tolerance; });
    const auto below = above - 1;
    const double t = std::log(tolerance / below->tolerance) / std::log(above->tolerance / below->tolerance);
    const auto between = [=](double a, double b) { return a * std::pow(b / a, t); };
    return work.facing * between(below->facing, above->facing) +
           work.touching * between(below->touching, above->touching);
}

double formFactorSeconds(const Work& work, bool occlusion) {
    const double patches = static_cast<double>(work.patches);
    FormFactorOptions options = work.options;
    options.occlusion = occlusion;
    options = settled(options);
    switch (options.method) {
        case Method::point: return work.facing * unit::point;
        case Method::polygon: return work.facing * unit::polygon;
        case Method::hemicube: {
            const double size = options.hemicubeSize;
            return patches * (patches * unit::hemicubePatch + size * size * unit::hemicubePixel);
        }
        case Method::hemisphere: return patches * static_cast<double>(options.rays) * unit::hemisphereRay;
        case Method::visibility:
            return exactSeconds(work) + work.facing * (unit::shaft + work.raysPerPair * unit::shaftRay);
        default: return exactSeconds(work);
    }
}

// Of rays from patches, those that meet specular faces or panes, once and again.
double specularHits(const Work& work, const Effects& effects) {
    if (!effects.specularInSolution()) return 0.0;
    const double goesOn = std::min(work.specularShare + work.clearShare, 0.9);
    return work.specularRays * goesOn / (1.0 - goesOn);
}

double specularSeconds(const Work& work, const Effects& effects) {
    const double hits = specularHits(work, effects);
    return hits > 0.0 ? (work.specularRays + hits) * unit::specularRay : 0.0;
}

// At most: many hits are of the same pair.
double specularEntries(const Work& work, const Effects& effects) {
    const double patches = static_cast<double>(work.patches);
    return std::min(patches * patches, 2.0 * specularHits(work, effects));
}

double radiositySeconds(const Work& work, const Effects& effects) {
    const double entries = static_cast<double>(work.patches) * static_cast<double>(work.patches);
    const double passes = effects.has(Effect::indirect) ? iterations + 1.0 : 1.0;
    const double all = entries + specularEntries(work, effects) * bytesOfSpecular / sizeof(double);
    return all * unit::pass * (2.0 + passes * effects.channels().count());  // two to check reciprocity
}

double pictureSeconds(const Work& work, const Effects& effects) {
    const double pixels = static_cast<double>(work.pixels);
    const double gather = raysPerGather * unit::hemisphereRay;
    double perSample = unit::cameraRay;
    if (effects.has(Effect::specular)) perSample += gather * work.specularShare;
    if (effects.has(Effect::transparency)) perSample += gather * work.clearShare;
    const double samples = effects.has(Effect::antialias) ? 1.0 + shareOfEdges * samplesOnEdges : 1.0;
    const double smooth = effects.has(Effect::smooth) ? static_cast<double>(work.patches) * unit::smoothPatch : 0.0;
    return pixels * (samples * perSample + unit::pixelOut) + smooth;
}

}  // namespace

Work workOf(const Scene& scene, const Geometry& geometry, const FormFactorOptions& options) {
    Work work;
    work.patches = geometry.patches.size();
    work.options = options;
    if (work.patches == 0) return work;
    countPairs(geometry.patches, work);
    work.raysPerPair = raysPerPair(geometry, options.rays ? options.rays : pairRays);
    work.specularRays = static_cast<double>(specularRays(geometry, scatteringsOf(scene)));
    work.specularShare = shareOfArea(scene, geometry, [](const Material& m) { return m.specular != Vec3f(0.0f); });
    work.clearShare = shareOfArea(scene, geometry, [](const Material& m) { return m.transparency > 0.0f; });
    return work;
}

Cost expectedCost(const Work& work, const Effects& effects) {
    const double patches = static_cast<double>(work.patches);
    Cost cost;
    cost.formFactors = formFactorSeconds(work, effects.has(Effect::occlusion));
    cost.specular = specularSeconds(work, effects);
    cost.radiosities = radiositySeconds(work, effects);
    cost.picture = pictureSeconds(work, effects);
    cost.bytes = patches * (patches * sizeof(double) + bytesOfNodes + bytesOfPatch) +
                 bytesOfSpecular * specularEntries(work, effects) + bytesOfPixel * static_cast<double>(work.pixels);
    return cost;
}

double costOf(Effect effect, const Work& work, const Effects& effects) {
    Effects other = effects;
    other[effect].on = !effects[effect].on;
    return std::abs(expectedCost(work, effects).seconds() - expectedCost(work, other).seconds());
}

}  // namespace radlab::engine
