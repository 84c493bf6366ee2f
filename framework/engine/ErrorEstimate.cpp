#include "engine/ErrorEstimate.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <tbb/parallel_for.h>

#include "base/Error.h"
#include "engine/ExchangeArea.h"
#include "engine/Visibility.h"

namespace radlab::engine {

namespace {

constexpr std::uint64_t otherRays = 1;  // than those that the radiosities were found with, or both would err alike
constexpr double closeEnough = 1e-4;    // of form factors: well below any error that is worth asking for

// Patches in order of their number, one after every so much area.
std::vector<std::size_t> sampled(const std::vector<Polygon>& patches, std::size_t samples) {
    double all = 0.0, passed = 0.0;
    for (const Polygon& patch : patches) all += patch.area;
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < patches.size(); ++i) {
        passed += patches[i].area;
        const double due = (static_cast<double>(chosen.size()) + 0.5) * all / static_cast<double>(samples);
        if (passed < due) continue;
        chosen.push_back(i);
        while ((static_cast<double>(chosen.size()) + 0.5) * all / static_cast<double>(samples) <= passed)
            chosen.push_back(i);
    }
    return chosen;
}

class Gatherer {
public:
    Gatherer(const Geometry& shapes, const ErrorEstimateOptions& options)
        : geometry(shapes), exchanges(shapes.patches, closeEnough) {
        if (options.occlusion) visibility = std::make_unique<Visibility>(shapes, options.rays, otherRays);
    }

    Point arrivingAt(std::size_t patch, const std::vector<Point>& radiosity) const {
        Point sum(0.0);
        for (std::size_t j = 0; j < radiosity.size(); ++j) {
            if (radiosity[j] == Point(0.0)) continue;
            const double exchange = exchanges(patch, j);
            if (exchange > 0.0) sum += exchange * share(patch, j) * radiosity[j];
        }
        return sum / geometry.patches[patch].area;
    }

private:
    double share(std::size_t i, std::size_t j) const {
        return !visibility ? 1.0 : visibility->visibleShare(std::min(i, j), std::max(i, j));
    }

    const Geometry& geometry;
    ExchangeAreas exchanges;
    std::unique_ptr<Visibility> visibility;
};

Point meanReflectance(const Geometry& geometry, const Surfaces& surfaces) {
    Point sum(0.0);
    double all = 0.0;
    for (std::size_t i = 0; i < geometry.patches.size(); ++i) {
        sum += geometry.patches[i].area * surfaces.reflectance[i];
        all += geometry.patches[i].area;
    }
    return sum / all;
}

}  // namespace

double estimateError(const Geometry& geometry, const Surfaces& surfaces, const std::vector<Point>& radiosity,
                     const ErrorEstimateOptions& options) {
    RADLAB_CHECK(radiosity.size() == geometry.patches.size());
    const std::vector<std::size_t> samples = sampled(geometry.patches, options.samples);
    if (samples.empty()) return 0.0;
    const Gatherer gatherer(geometry, options);
    std::vector<Point> residuals(samples.size());
    tbb::parallel_for(std::size_t{0}, samples.size(), [&](std::size_t k) {
        const std::size_t i = samples[k];
        residuals[k] =
            surfaces.emission[i] + surfaces.reflectance[i] * gatherer.arrivingAt(i, radiosity) - radiosity[i];
    });
    Point mean(0.0), square(0.0);
    for (const Point& residual : residuals) {
        mean += residual / static_cast<double>(residuals.size());
        square += residual * residual / static_cast<double>(residuals.size());
    }
    const Point goesOn = mean / glm::max(1.0 - meanReflectance(geometry, surfaces), Point(1e-6));
    const Point error = square - mean * mean + goesOn * goesOn;
    double all = 0.0, area = 0.0;
    for (std::size_t i = 0; i < radiosity.size(); ++i) {
        all += geometry.patches[i].area * glm::dot(radiosity[i], radiosity[i]);
        area += geometry.patches[i].area;
    }
    return all > 0.0 ? std::sqrt(std::max(error.x + error.y + error.z, 0.0) * area / all) : 0.0;
}

}  // namespace radlab::engine
