#include "study/Reference.h"

#include <algorithm>
#include <cmath>

#include "base/Error.h"
#include "engine/ErrorEstimate.h"
#include "engine/FormFactors.h"
#include "engine/HierarchicalRadiosity.h"
#include "engine/MeshError.h"

namespace radlab::study {

using namespace engine;

namespace {

constexpr double tolerance = 1e-9;  // of unoccluded form factors
constexpr double mostSplits = 10.0;

double splitsFor(const StudyMesh& coarse, std::size_t mostPatches) {
    const double each = static_cast<double>(mostPatches) / static_cast<double>(coarse.geometry.patches.size());
    return std::clamp(std::floor(std::sqrt(each)), 1.0, mostSplits);
}

}  // namespace

double relativeError(const std::vector<double>& areas, const std::vector<Point>& found,
                     const std::vector<Point>& truth) {
    RADLAB_CHECK(found.size() == truth.size());
    RADLAB_CHECK(areas.size() == truth.size());
    double error = 0.0, all = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const Point off = found[i] - truth[i];
        error += areas[i] * glm::dot(off, off);
        all += areas[i] * glm::dot(truth[i], truth[i]);
    }
    return all > 0.0 ? std::sqrt(error / all) : 0.0;
}

SolverReference solverReference(const StudyMesh& mesh, std::size_t rays) {
    FormFactorOptions options;
    options.occlusion = mesh.occlusion;
    options.rays = rays;
    options.tolerance = tolerance;
    SolverReference reference;
    reference.radiosity = solveRadiosity(formFactors(mesh.geometry, options), mesh.surfaces);
    ErrorEstimateOptions estimate;
    estimate.rays = rays;
    estimate.occlusion = mesh.occlusion;
    reference.error = estimateError(mesh.geometry, mesh.surfaces, reference.radiosity, estimate);
    return reference;
}

WholeReference::WholeReference(const StudyMesh& coarse, std::size_t mostPatches, double threshold) {
    const FineMesh fine(coarse, splitsFor(coarse, mostPatches));
    HierarchicalOptions options;
    options.occlusion = coarse.occlusion;
    options.threshold = threshold;
    truth = solveHierarchical(fine.geometry, fine.surfaces, options);
    coarseOf = fine.mesh.faceOf;
    areas = areasOf(fine.geometry);
    ErrorEstimateOptions estimate;
    estimate.occlusion = coarse.occlusion;
    solutionError = estimateError(fine.geometry, fine.surfaces, truth, estimate);
    fineMeshError = estimateMeshError(fine.mesh, truth);
}

double WholeReference::errorOf(const std::vector<Point>& radiosity) const {
    std::vector<Point> found;
    for (const int patch : coarseOf) found.push_back(radiosity.at(static_cast<std::size_t>(patch)));
    return std::hypot(relativeError(areas, found, truth), fineMeshError);
}

}  // namespace radlab::study
