#include "engine/RoomSolver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/Error.h"
#include "engine/FormFactorRows.h"
#include "engine/HierarchicalRadiosity.h"
#include "engine/Shooting.h"

namespace radlab::engine {

namespace {

constexpr double unfit = std::numeric_limits<double>::infinity();
constexpr std::size_t largestMatrix = 5000;  // patches
constexpr std::size_t rays = 1024;           // for a pair that is partly hidden

std::vector<Point> solved(const HardRoom& hard, Solver solver) {
    if (solver == Solver::links) {
        HierarchicalOptions options;
        options.occlusion = hard.occlusion;
        options.threshold = 1e-4;
        options.rays = rays;
        return solveHierarchical(hard.geometry, hard.surfaces, options);
    }
    FormFactorOptions factors;
    factors.occlusion = hard.occlusion;
    factors.tolerance = 1e-12;
    factors.rays = rays;
    if (solver == Solver::matrix) return solveRadiosity(formFactors(hard.geometry, factors), hard.surfaces);
    const FormFactorRows rows(hard.geometry, factors);
    ShootingOptions options;
    options.unshot = 1e-7;
    options.mostShots = 100'000;
    return shootRadiosity(
        areasOf(hard.geometry), hard.surfaces, [&](std::size_t i, double* row) { rows.row(i, row); }, options);
}

// Absolute where the truth is 0.
double relativeError(double found, double truth) { return std::abs(found - truth) / (truth > 0.0 ? truth : 1.0); }

double errorIn(const HardRoom& hard, const std::vector<Point>& found) {
    if (hard.truth.empty()) return unfit;
    double worst = 0.0, mean = 0.0, area = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (!std::isfinite(found[i].x) || found[i].x < hard.surfaces.emission[i].x) return unfit;
        mean += hard.geometry.patches[i].area * found[i].x;
        area += hard.geometry.patches[i].area;
        if (hard.truth.size() == found.size()) worst = std::max(worst, relativeError(found[i].x, hard.truth[i]));
    }
    return hard.truth.size() == found.size() ? worst : relativeError(mean / area, hard.truth[0]);
}

}  // namespace

std::string nameOf(Solver solver) {
    return solver == Solver::matrix ? "matrix" : solver == Solver::shooting ? "shooting" : "links";
}

double allowedError(const HardRoom& hard, Solver solver) {
    if (solver == Solver::links) return hard.links;
    if (hard.geometry.patches.size() > largestMatrix) return unfit;
    return solver == Solver::matrix ? hard.matrix : hard.shooting;
}

double errorOf(const HardRoom& hard, Solver solver) {
    try {
        return errorIn(hard, solved(hard, solver));
    } catch (const Error&) {
        return hard.truth.empty() ? 0.0 : unfit;
    }
}

}  // namespace radlab::engine
