#include "engine/FormFactorRows.h"

#include <algorithm>

#include "base/Interrupts.h"
#include "engine/LowDiscrepancy.h"
#include "engine/PointFormFactor.h"
#include "engine/Scattering.h"

namespace radlab::engine {

FormFactorRows::FormFactorRows(const Geometry& shapes, const FormFactorOptions& asked)
    : geometry(shapes), options(settled(asked)) {
    switch (options.method) {
        case Method::hemicube: hemicubes = std::make_unique<Hemicubes>(geometry.patches, options.hemicubeSize); break;
        case Method::hemisphere: scene = std::make_unique<RayScene>(geometry.patches); break;
        case Method::visibility:
            visibility = std::make_unique<Visibility>(geometry, options.rays, options.seed);
            [[fallthrough]];
        case Method::exact: exchanges = std::make_unique<ExchangeAreas>(geometry.patches, options.tolerance); break;
        default: break;
    }
}

double FormFactorRows::exchange(std::size_t i, std::size_t j) const {
    Interrupts::check();
    const std::vector<Polygon>& patches = geometry.patches;
    if (options.method == Method::point) return patches[i].area * pointToPoint(patches[i], patches[j]);
    const double unoccluded = (*exchanges)(i, j);
    return unoccluded > 0.0 && visibility ? unoccluded * visibility->visibleShare(i, j) : unoccluded;
}

void FormFactorRows::row(std::size_t from, double* factors) const {
    if (hemicubes) return hemicubes->row(from, factors);
    std::fill_n(factors, geometry.patches.size(), 0.0);
    if (!(geometry.patches[from].area > 0.0)) return;
    if (scene) return byHemisphere(from, factors);
    if (options.method == Method::polygon) return byPoints(from, factors);
    byPairs(from, factors);
}

void FormFactorRows::byPairs(std::size_t from, double* factors) const {
    for (std::size_t j = 0; j < geometry.patches.size(); ++j)
        if (j != from)
            factors[j] = std::max(exchange(std::min(from, j), std::max(from, j)), 0.0) / geometry.patches[from].area;
}

void FormFactorRows::byPoints(std::size_t from, double* factors) const {
    const Polygon& patch = geometry.patches[from];
    for (std::size_t j = 0; j < geometry.patches.size(); ++j) {
        Interrupts::check();
        if (j != from) factors[j] = pointToPolygon(patch.center, patch.normal, geometry.patches[j]);
    }
}

void FormFactorRows::byHemisphere(std::size_t from, double* factors) const {
    const Polygon& patch = geometry.patches[from];
    const AreaSampler sampler(patch);
    const LowDiscrepancy points(from);
    for (std::size_t k = 0; k < options.rays; ++k) {
        Interrupts::check();
        const auto at = points.at(k);
        follow(sampler.at(at[0], at[1]), cosineDirection(patch.normal, at[2], at[3]), from, factors);
    }
    for (std::size_t j = 0; j < geometry.patches.size(); ++j) factors[j] /= static_cast<double>(options.rays);
}

// Adds what arrives along a ray to all fronts that it meets, on through panes.
void FormFactorRows::follow(Point from, const Point& direction, std::size_t start, double* arrived) const {
    double share = 1.0;
    for (int pane = 0; pane < mostPanes && share > 0.0; ++pane) {
        const RayHit hit = scene->meet(from, direction, start);
        if (hit.polygon == RayHit::nothing) return;
        if (glm::dot(direction, geometry.patches[hit.polygon].normal) < 0.0) arrived[hit.polygon] += share;
        share *= geometry.throughPatch(hit.polygon);
        from += hit.distance * direction;
        start = hit.polygon;
    }
}

std::size_t FormFactorRows::rays() const { return scene ? scene->rays() : visibility ? visibility->rays() : 0; }

}  // namespace radlab::engine
