#include "engine/ErrorEstimate.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <tbb/parallel_for.h>

#include "base/Error.h"
#include "engine/FormFactorRows.h"
#include "engine/SpecularTransport.h"

namespace radlab::engine {

namespace {

constexpr std::uint64_t otherRays = 1;  // than those that the radiosities were found with, or both would err alike
constexpr double closeEnough = 1e-4;    // of form factors: well below any error that is worth asking for

using Specular = std::optional<SpecularTransport>;

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

Point arrivingAt(std::size_t patch, const Geometry& geometry, const FormFactorRows& rows, const Specular& specular,
                 const std::vector<Point>& radiosity) {
    Point sum(0.0);
    for (std::size_t j = 0; j < radiosity.size(); ++j)
        if (j != patch && radiosity[j] != Point(0.0))
            sum += rows.exchange(std::min(patch, j), std::max(patch, j)) * radiosity[j];
    if (specular)
        for (const PatchExchange& other : specular->row(patch)) sum += other.exchange * radiosity[other.patch];
    return sum / geometry.patches[patch].area;
}

FormFactorOptions exactly(const ErrorEstimateOptions& options) {
    FormFactorOptions exact;
    exact.occlusion = options.occlusion;
    exact.rays = options.rays;
    exact.seed = otherRays;
    exact.tolerance = closeEnough;
    return exact;
}

// Good enough for what the samples get.
Specular specularOf(const Geometry& geometry, const std::vector<std::size_t>& samples,
                    const ErrorEstimateOptions& options) {
    if (options.scatterings.empty()) return std::nullopt;
    SpecularOptions specular;
    specular.rays = options.specularRays;
    specular.seed = otherRays;
    specular.senders = samples;
    return std::make_optional<SpecularTransport>(geometry, options.scatterings, specular);
}

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
    const FormFactorRows rows(geometry, exactly(options));
    const Specular specular = specularOf(geometry, samples, options);
    std::vector<Point> residuals(samples.size());
    tbb::parallel_for(std::size_t{0}, samples.size(), [&](std::size_t k) {
        const std::size_t i = samples[k];
        residuals[k] = surfaces.emission[i] +
                       surfaces.reflectance[i] * arrivingAt(i, geometry, rows, specular, radiosity) - radiosity[i];
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
