#include "study/Reference.h"

#include <algorithm>
#include <cmath>

#include "engine/ErrorEstimate.h"
#include "engine/FormFactors.h"
#include "engine/HierarchicalRadiosity.h"
#include "engine/MeshError.h"
#include "engine/RelativeError.h"
#include "engine/Subdivision.h"

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
    const Subdivision fine = subdivide(coarse.scene, coarse.mesh, coarse.patchSize, splitsFor(coarse, mostPatches));
    const Surfaces surfaces = surfacesOf(*fine.mesh);
    HierarchicalOptions options;
    options.occlusion = coarse.occlusion;
    options.threshold = threshold;
    truth = solveHierarchical(fine.geometry, surfaces, options);
    coarseOf = fine.coarseOf;
    areas = areasOf(fine.geometry);
    ErrorEstimateOptions estimate;
    estimate.occlusion = coarse.occlusion;
    solutionError = estimateError(fine.geometry, surfaces, truth, estimate);
    fineMeshError = estimateMeshError(*fine.mesh, truth);
}

double WholeReference::errorOf(const std::vector<Point>& radiosity) const {
    std::vector<Point> found;
    for (const std::size_t patch : coarseOf) found.push_back(radiosity.at(patch));
    return std::hypot(relativeError(areas, found, truth), fineMeshError);
}

}  // namespace radlab::study
