#include "engine/Ways.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include "engine/HierarchicalRadiosity.h"
#include "engine/SpecularTransport.h"

namespace radlab::engine {

namespace {

constexpr double tolerance = 1e-4;  // of form factors: far below the errors of rays

// Measured on machine A of BENCHMARKS.md, both cores, 2026-11-23: rooms of about 1,000 patches, their errors' median.
namespace measured {

struct Links {
    double threshold, error, clear,
        hidden;  // seconds for a patch, where nothing hides anything and where something does
};
constexpr std::array<Links, 6> links{{{1e-1, 1.2e-2, 8e-6, 2.8e-5},
                                      {1e-2, 8.6e-3, 9e-6, 3.3e-5},
                                      {1e-3, 6.1e-3, 1.3e-5, 4.9e-5},
                                      {1e-4, 2.4e-3, 3.1e-5, 1.1e-4},
                                      {1e-5, 7.3e-4, 9e-5, 2.9e-4},
                                      {1e-6, 3e-4, 2.5e-4, 8e-4}}};

struct Size {
    double size, error;
};
constexpr std::array<Size, 5> hemicubes{{{16, 1.6e-2}, {32, 7e-3}, {64, 5e-3}, {128, 3.3e-3}, {256, 2.6e-3}}};
constexpr std::array<double, 5> pairRays{16, 32, 64, 128, 256};
constexpr double ofPairRays = 2e-3;  // error, times √rays
constexpr std::array<double, 4> hemisphereRays{256, 1024, 4096, 16384};
constexpr double ofHemisphereRays = 0.33;  // error, times √rays
constexpr double exact = 1e-7;
constexpr std::array<std::size_t, 9> specularRays{256, 512, 1024, 2048, 4096, 8192, 16384, 32768, 65536};
constexpr double ofSpecularRays = 0.05;  // error, times √rays; of mirror.x3d

}  // namespace measured

Way byMatrix(const Work& work, const Effects& effects, Method method, double setting, double error) {
    Work asked = work;
    asked.options.method = method;
    asked.options.tolerance = tolerance;
    if (method == Method::hemicube)
        asked.options.hemicubeSize = static_cast<int>(setting);
    else
        asked.options.rays = static_cast<std::size_t>(setting);
    if (method == Method::visibility)
        asked.raysPerPair *= setting / static_cast<double>(work.options.rays > 0 ? work.options.rays : pairRays);
    const Cost cost = expectedCost(asked, effects);
    return {false, method, setting, 0, error, cost.formFactors + cost.radiosities};
}

// For light that goes straight from patch to patch.
std::vector<Way> diffuseWays(const Work& work, const Effects& effects) {
    const bool occlusion = effects.has(Effect::occlusion);
    const double patches = static_cast<double>(work.patches);
    std::vector<Way> ways;
    for (const measured::Links& one : measured::links)
        ways.push_back(
            {true, Method::automatic, one.threshold, 0, one.error, patches * (occlusion ? one.hidden : one.clear)});
    if (!occlusion) {
        ways.push_back(byMatrix(work, effects, Method::exact, 0.0, measured::exact));
        return ways;
    }
    if (!effects.has(Effect::transparency))  // hemicubes take panes for opaque
        for (const measured::Size& one : measured::hemicubes)
            ways.push_back(byMatrix(work, effects, Method::hemicube, one.size, one.error));
    for (const double rays : measured::hemisphereRays)
        ways.push_back(byMatrix(work, effects, Method::hemisphere, rays, measured::ofHemisphereRays / std::sqrt(rays)));
    for (const double rays : measured::pairRays)
        ways.push_back(byMatrix(work, effects, Method::visibility, rays, measured::ofPairRays / std::sqrt(rays)));
    return ways;
}

}  // namespace

std::string describe(const Way& way) {
    const std::string specular =
        way.specularRays > 0 ? "; " + std::to_string(way.specularRays) + " specular rays a patch" : "";
    char text[80];
    if (way.links)
        std::snprintf(text, sizeof text, "links, threshold %g", way.setting);
    else if (way.method == Method::hemicube)
        std::snprintf(text, sizeof text, "hemicubes of size %g", way.setting);
    else if (way.setting > 0.0)
        std::snprintf(text, sizeof text, "%s, %g rays", nameOf(way.method).c_str(), way.setting);
    else
        std::snprintf(text, sizeof text, "%s", nameOf(way.method).c_str());
    return text + specular;
}

std::vector<Way> waysFor(const Work& work, const Effects& effects) {
    const std::vector<Way> diffuse = diffuseWays(work, effects);
    if (!effects.specularInSolution()) return diffuse;
    const double usualSeconds = expectedCost(work, effects).specular;
    std::vector<Way> ways;
    for (const std::size_t rays : measured::specularRays)
        for (Way way : diffuse) {
            const double times = static_cast<double>(rays) / static_cast<double>(SpecularOptions().rays);
            way.specularRays = rays;
            way.error = std::hypot(way.error, measured::ofSpecularRays / std::sqrt(static_cast<double>(rays)));
            way.seconds += times * usualSeconds;
            ways.push_back(way);
        }
    return ways;
}

Way cheapestWay(const std::vector<Way>& ways, double error, double factor) {
    Way best =
        *std::min_element(ways.begin(), ways.end(), [](const Way& a, const Way& b) { return a.error < b.error; });
    for (const Way& way : ways)
        if (way.error * factor <= error && way.seconds < best.seconds) best = way;
    return best;
}

std::vector<Point> solveBy(const Way& way, const Geometry& geometry, const Surfaces& surfaces,
                           const std::vector<Scattering>& scatterings, const Effects& effects) {
    std::optional<SpecularTransport> specular;
    if (way.specularRays > 0) {
        SpecularOptions options;
        options.rays = way.specularRays;
        specular.emplace(geometry, scatterings, options);
    }
    const ChannelExchange further = specular ? specular->further() : ChannelExchange();
    if (way.links) {
        HierarchicalOptions options;
        options.threshold = way.setting;
        options.occlusion = effects.has(Effect::occlusion);
        options.indirect = effects.has(Effect::indirect);
        options.channels = effects.channels();
        options.further = further;
        return solveHierarchical(geometry, surfaces, options);
    }
    FormFactorOptions options;
    options.method = way.method;
    options.tolerance = tolerance;
    options.occlusion = effects.has(Effect::occlusion);
    if (way.method == Method::hemicube)
        options.hemicubeSize = static_cast<int>(way.setting);
    else
        options.rays = static_cast<std::size_t>(way.setting);
    FormFactorMatrix matrix = formFactors(geometry, options);
    if (!isReciprocal(way.method)) makeReciprocal(matrix);
    SolverOptions solving;
    solving.channels = effects.channels();
    solving.indirect = effects.has(Effect::indirect);
    Transport transport = transportOf(matrix);
    transport.further = further;
    return solveRadiosity(transport, surfaces, solving);
}

}  // namespace radlab::engine
