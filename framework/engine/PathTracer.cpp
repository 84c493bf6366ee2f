#include "engine/PathTracer.h"

#include <cmath>
#include <numbers>

#include "base/Error.h"
#include "base/Interrupts.h"
#include "engine/LowDiscrepancy.h"
#include "engine/PathWalk.h"

namespace radlab::engine {

namespace {

constexpr std::size_t replicates = 32;

// The mean over one sequence of points of a patch and directions from them.
Point meanIrradiance(const PathWalk& walk, std::size_t patch, std::uint64_t key, std::size_t samples) {
    const LowDiscrepancy points(key);
    Point sum(0.0);
    for (std::size_t k = 0; k < samples; ++k) {
        Interrupts::check();
        const auto at = points.at(k);
        RandomNumbers random(key, k);
        sum += walk.arriving(patch, walk.pointOf(patch, at[0], at[1]), at[2], at[3], random);
    }
    return std::numbers::pi / static_cast<double>(samples) * sum;
}

struct Estimate {
    Point mean{0.0}, standardError{0.0};
};

Estimate irradianceOf(const PathWalk& walk, std::size_t patch, std::size_t samplesEach) {
    Point sum(0.0), squares(0.0);
    constexpr auto count = static_cast<double>(replicates);
    Point first(0.0);  // squares of differences to it lose no digits
    for (std::size_t r = 0; r < replicates; ++r) {
        const Point mean = meanIrradiance(walk, patch, patch * replicates + r, samplesEach);
        if (r == 0) first = mean;
        sum += mean - first;
        squares += (mean - first) * (mean - first);
    }
    const Point variance = glm::max(Point(0.0), squares - sum * sum / count) / (count - 1.0);
    return {first + sum / count, glm::sqrt(variance / count)};
}

}  // namespace

PathRadiosity pathTraceRadiosity(const TracedScene& scene, const PathRadiosityOptions& options) {
    RADLAB_CHECK(options.samples >= 1u);
    const std::size_t count = scene.patches().size(), samplesEach = (options.samples + replicates - 1) / replicates;
    const PathWalk walk(scene, options.constantPatches);
    PathRadiosity result{std::vector<Point>(count), std::vector<Point>(count, Point(0.0)), samplesEach * replicates, 0};
    const std::size_t before = scene.rays();
    forAll(count, options.progress, [&](std::size_t i) {
        const Scattering& scattering = scene.scattering(i);
        result.radiosity[i] = scattering.emission;
        if (scattering.diffuse == Point(0.0) || !(scene.patches()[i].area > 0.0)) return;
        const Estimate irradiance = irradianceOf(walk, i, samplesEach);
        result.radiosity[i] += scattering.diffuse * irradiance.mean;
        result.standardError[i] = scattering.diffuse * irradiance.standardError;
    });
    result.rays = scene.rays() - before;
    return result;
}

Image pathTracePicture(const TracedScene& scene, const Frame& frame, std::size_t samples, const Progress& progress) {
    RADLAB_CHECK(samples >= 1u);
    const PathWalk walk(scene, false);
    const CameraRays camera(frame);
    Image image(frame.width, frame.height);
    const auto trace = [&](int x, int y) {
        const auto key =
            static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(frame.width) + static_cast<std::uint64_t>(x);
        const LowDiscrepancy points(key);
        Point sum(0.0);
        for (std::size_t k = 0; k < samples; ++k) {
            Interrupts::check();
            const auto at = points.at(k);
            RandomNumbers random(key, k);
            sum += walk.radiance(camera.eye(), camera.direction(x + at[0], y + at[1]), frame.background, random);
        }
        image.at(x, y) = glm::vec3(sum / static_cast<double>(samples));
    };
    doneWhole([&] { forAllPixels(frame.width, frame.height, progress, trace); });
    return image;
}

}  // namespace radlab::engine
