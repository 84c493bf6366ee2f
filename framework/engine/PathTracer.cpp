#include "engine/PathTracer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "base/Error.h"
#include "base/Interrupts.h"
#include "engine/LowDiscrepancy.h"
#include "engine/PathWalk.h"

namespace radlab::engine {

namespace {

constexpr std::size_t replicates = 32;

// Calls pass(from, to) for one range of samples after the other: few at first, so that soon there is something of everything,
// and never so many that progress would stand still.
//
// Returns how many samples each has got at least: fewer than all where Ctrl-C ended it.
std::size_t inPasses(std::size_t samples, const std::function<void(std::size_t from, std::size_t to)>& pass) {
    constexpr std::size_t most = 16;
    std::size_t done = 0;
    doneWhole([&] {
        while (done < samples) {
            const std::size_t to = std::min(samples, done + std::clamp<std::size_t>(done, 1, most));
            pass(done, to);
            done = to;
        }
    });
    if (done == 0) throw Interrupted();
    return done;
}

// The sums over the sequences of points of a patch and directions from them, and how long these are by now.
struct PatchSums {
    std::array<Point, replicates> sums{};
    std::size_t samples = 0;
};

PatchSums continued(PatchSums so, const PathWalk& walk, std::size_t patch, std::size_t to) {
    for (std::size_t r = 0; r < replicates; ++r) {
        const std::uint64_t key = patch * replicates + r;
        const LowDiscrepancy points(key);
        for (std::size_t k = so.samples; k < to; ++k) {
            Interrupts::check();
            const auto at = points.at(k);
            RandomNumbers random(key, k);
            so.sums[r] += walk.arriving(patch, walk.pointOf(patch, at[0], at[1]), at[2], at[3], random);
        }
    }
    so.samples = to;
    return so;
}

struct Estimate {
    Point mean{0.0}, standardError{0.0};
};

Estimate irradianceOf(const PatchSums& of) {
    Point sum(0.0), squares(0.0);
    constexpr auto count = static_cast<double>(replicates);
    const auto mean = [&](std::size_t r) { return std::numbers::pi / static_cast<double>(of.samples) * of.sums[r]; };
    const Point first = mean(0);  // squares of differences to it lose no digits
    for (std::size_t r = 0; r < replicates; ++r) {
        sum += mean(r) - first;
        squares += (mean(r) - first) * (mean(r) - first);
    }
    const Point variance = glm::max(Point(0.0), squares - sum * sum / count) / (count - 1.0);
    return {first + sum / count, glm::sqrt(variance / count)};
}

}  // namespace

std::size_t pathsOf(std::size_t samples) { return (samples + replicates - 1) / replicates * replicates; }

PathRadiosity pathTraceRadiosity(const TracedScene& scene, const PathRadiosityOptions& options) {
    RADLAB_CHECK(options.samples >= 1u);
    const std::size_t count = scene.patches().size(), samplesEach = pathsOf(options.samples) / replicates;
    const PathWalk walk(scene, options.constantPatches);
    const auto reflects = [&](std::size_t i) {
        return scene.scattering(i).diffuse != Point(0.0) && scene.patches()[i].area > 0.0;
    };
    const std::size_t before = scene.rays();
    std::vector<PatchSums> sums(count);
    const std::size_t fewest = inPasses(samplesEach, [&](std::size_t from, std::size_t to) {
        const Progress told = [&](std::size_t patches) {
            if (options.progress) options.progress(replicates * (from * count + (to - from) * patches));
        };
        forAll(count, told, [&](std::size_t i) {
            if (reflects(i)) sums[i] = continued(sums[i], walk, i, to);
        });
    });
    PathRadiosity result{{}, std::vector<Point>(count, Point(0.0)), fewest * replicates, scene.rays() - before};
    for (std::size_t i = 0; i < count; ++i) {
        const Scattering& scattering = scene.scattering(i);
        result.radiosity.push_back(scattering.emission);
        if (!reflects(i)) continue;
        const Estimate irradiance = irradianceOf(sums[i]);
        result.radiosity[i] += scattering.diffuse * irradiance.mean;
        result.standardError[i] = scattering.diffuse * irradiance.standardError;
    }
    return result;
}

Image pathTracePicture(const TracedScene& scene, const Frame& frame, std::size_t samples, const Progress& progress,
                       std::size_t* fewest) {
    RADLAB_CHECK(samples >= 1u);
    const PathWalk walk(scene, false);
    const CameraRays camera(frame);
    Image image(frame.width, frame.height);
    const std::size_t count = image.data().size(), tiles = tilesOf(frame.width, frame.height);
    std::vector<Point> sums(count, Point(0.0));
    std::vector<std::size_t> taken(count, 0);
    const auto trace = [&](int x, int y, std::size_t to) {
        const std::size_t pixel =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width) + static_cast<std::size_t>(x);
        const LowDiscrepancy points(pixel);
        Point sum = sums[pixel];
        for (std::size_t k = taken[pixel]; k < to; ++k) {
            Interrupts::check();
            const auto at = points.at(k);
            RandomNumbers random(pixel, k);
            sum += walk.radiance(camera.eye(), camera.direction(x + at[0], y + at[1]), frame.background, random);
        }
        sums[pixel] = sum;
        taken[pixel] = to;
    };
    const std::size_t done = inPasses(samples, [&](std::size_t from, std::size_t to) {
        const Progress told = [&](std::size_t tile) {
            if (progress) progress(from * count + (to - from) * count * tile / tiles);
        };
        forAllPixels(frame.width, frame.height, told, [&](int x, int y) { trace(x, y, to); });
    });
    for (std::size_t i = 0; i < count; ++i) image.data()[i] = glm::vec3(sums[i] / static_cast<double>(taken[i]));
    if (fewest) *fewest = done;
    return image;
}

}  // namespace radlab::engine
