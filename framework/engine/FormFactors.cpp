#include "engine/FormFactors.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <mutex>
#include <numbers>

#include <tbb/parallel_for.h>

#include "base/Error.h"
#include "base/Stopwatch.h"
#include "engine/ExchangeArea.h"
#include "engine/Hemicubes.h"
#include "engine/LowDiscrepancy.h"
#include "engine/PointFormFactor.h"
#include "engine/Visibility.h"

namespace radlab::engine {

namespace {

struct Named {
    const char* name;
    Method method;
};

constexpr std::array<Named, 7> names = {{{"point", Method::point},
                                         {"polygon", Method::polygon},
                                         {"exact", Method::exact},
                                         {"hemicube", Method::hemicube},
                                         {"hemisphere", Method::hemisphere},
                                         {"visibility", Method::visibility},
                                         {"auto", Method::automatic}}};

constexpr std::size_t hemisphereRays = 4096, pairRays = 64;

// Fills rows on all cores; what a row writes is its own business, and no other's.
void forAllRows(std::size_t count, const std::function<void(std::size_t)>& progress,
                const std::function<void(std::size_t row)>& fill) {
    std::atomic<std::size_t> done{0};
    std::mutex telling;
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
        fill(i);
        const std::size_t now = ++done;
        if (!progress) return;
        const std::unique_lock lock(telling, std::try_to_lock);
        if (lock) progress(now);
    });
}

// A function of pairs that gives the exchange area: both entries of a pair are written by the row of the first.
template <class Exchange>
void fillPairs(FormFactorMatrix& matrix, const FormFactorOptions& options, const Exchange& exchange) {
    const std::vector<double>& areas = matrix.areas();
    forAllRows(matrix.size(), options.progress, [&](std::size_t i) {
        for (std::size_t j = i + 1; j < matrix.size(); ++j) {
            const double area = exchange(i, j);
            if (area <= 0.0) continue;
            matrix.at(i, j) = area / areas[i];
            matrix.at(j, i) = area / areas[j];
        }
    });
}

void fillHemispheres(FormFactorMatrix& matrix, const Geometry& geometry, const RayScene& scene,
                     const FormFactorOptions& options) {
    const std::size_t rays = options.rays ? options.rays : hemisphereRays;
    forAllRows(matrix.size(), options.progress, [&](std::size_t i) {
        const Polygon& patch = geometry.patches[i];
        if (!(patch.area > 0.0)) return;
        const AreaSampler sampler(patch);
        const Point x = glm::normalize(patch.corners[1] - patch.corners[0]), y = glm::cross(patch.normal, x);
        const LowDiscrepancy points(i);
        std::vector<std::size_t> hits(matrix.size());
        for (std::size_t k = 0; k < rays; ++k) {
            const auto at = points.at(k);
            const double radius = std::sqrt(at[2]), angle = 2.0 * std::numbers::pi * at[3];
            const Point direction =
                radius * std::cos(angle) * x + radius * std::sin(angle) * y + std::sqrt(1.0 - at[2]) * patch.normal;
            const std::size_t hit = scene.firstHit(sampler.at(at[0], at[1]), direction, i);
            if (hit != RayScene::nothing && glm::dot(direction, geometry.patches[hit].normal) < 0.0) ++hits[hit];
        }
        for (std::size_t j = 0; j < matrix.size(); ++j)
            matrix.at(i, j) = static_cast<double>(hits[j]) / static_cast<double>(rays);
    });
}

std::size_t fill(FormFactorMatrix& matrix, const Geometry& geometry, Method method, const FormFactorOptions& options) {
    const std::vector<Polygon>& patches = geometry.patches;
    switch (method) {
        case Method::point:
            fillPairs(matrix, options, [&](std::size_t i, std::size_t j) {
                return patches[i].area * pointToPoint(patches[i], patches[j]);
            });
            return 0;
        case Method::polygon:
            forAllRows(matrix.size(), options.progress, [&](std::size_t i) {
                for (std::size_t j = 0; j < matrix.size(); ++j)
                    if (i != j) matrix.at(i, j) = pointToPolygon(patches[i].center, patches[i].normal, patches[j]);
            });
            return 0;
        case Method::hemicube: {
            const Hemicubes hemicubes(patches, options.hemicubeSize);
            forAllRows(matrix.size(), options.progress, [&](std::size_t i) { hemicubes.row(i, &matrix.at(i, 0)); });
            return 0;
        }
        case Method::hemisphere: {
            const RayScene scene(patches);
            fillHemispheres(matrix, geometry, scene, options);
            return scene.rays();
        }
        case Method::visibility: {
            const Visibility visibility(geometry, options.rays ? options.rays : pairRays);
            const ExchangeAreas unoccluded(patches, options.tolerance);
            fillPairs(matrix, options, [&](std::size_t i, std::size_t j) {
                const double exchange = unoccluded(i, j);
                return exchange > 0.0 ? exchange * visibility.visibleShare(i, j) : 0.0;
            });
            return visibility.rays();
        }
        default: fillPairs(matrix, options, ExchangeAreas(patches, options.tolerance)); return 0;
    }
}

}  // namespace

Method methodNamed(const std::string& name) {
    std::string known;
    for (const Named& one : names) {
        if (name == one.name) return one.method;
        known += (known.empty() ? "" : ", ") + std::string(one.name);
    }
    throw Error("method: found '" + name + "', expected one of " + known);
}

std::string nameOf(Method method) {
    return std::find_if(names.begin(), names.end(), [=](const Named& one) { return one.method == method; })->name;
}

bool isReciprocal(Method method) {
    return method != Method::polygon && method != Method::hemicube && method != Method::hemisphere;
}

FormFactorMatrix formFactors(const Geometry& geometry, const FormFactorOptions& options, FormFactorReport* report) {
    const Stopwatch watch;
    FormFactorMatrix matrix(geometry.patches);
    Method method = options.method;
    if (method == Method::automatic) method = options.occlusion ? Method::visibility : Method::exact;
    const std::size_t rays = fill(matrix, geometry, method, options);
    if (report) *report = {method, rays, watch.seconds()};
    return matrix;
}

}  // namespace radlab::engine
