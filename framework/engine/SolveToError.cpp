#include "engine/SolveToError.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/Stopwatch.h"
#include "engine/ErrorEstimate.h"
#include "engine/MeshError.h"
#include "engine/Scattering.h"

namespace radlab::engine {

namespace {

constexpr double margin = 1.6;           // by which estimates may be too low
constexpr double ofSolver = 0.5;         // share of the goal that the solver may use up
constexpr double usualVariation = 0.25;  // mesh error times √patches, in a room
constexpr double mostPatches = 200'000.0;
constexpr std::size_t times = 4;  // as many specular rays in estimates: their own noise then hardly counts

double firstSize(const Scene& scene, double error) {
    const double patches = std::pow(usualVariation * margin / error, 2.0);
    return patchSizeFor(scene, std::clamp(patches, 200.0, mostPatches));
}

class Search {
public:
    Search(const Scene& asked, const Effects& found, const ErrorGoal& wanted)
        : scene(asked), effects(found), goal(wanted), scatterings(scatteringsOf(asked, found)) {
        solution.patchSize = chosenMesh() ? firstSize(scene, goal.error) : goal.patchSize;
    }

    AccurateSolution run() {
        for (int tries = 0; tries < mostTries && !solution.reached; ++tries) {
            if (!solution.mesh) cut();
            solve();
            estimate();
            if (!solution.reached) adjust();
        }
        return std::move(solution);
    }

private:
    bool chosenMesh() const { return goal.patchSize == 0.0; }

    void tell(const std::string& what) const {
        if (goal.progress) goal.progress(what);
    }

    void cut() {
        const auto size = static_cast<float>(solution.patchSize);
        solution.mesh = std::make_unique<PatchMesh>(scene.vertices, scene.faces, size, size);
        solution.geometry = geometryOf(scene, *solution.mesh);
        solution.geometry.through = throughOf(scatterings);
        solution.surfaces = surfacesOf(*solution.mesh, scatterings);
        ways = waysFor(workOf(scene, solution.geometry, {}), effects);
    }

    void solve() {
        const double target = (chosenMesh() ? ofSolver : 1.0) * goal.error / margin;
        solution.way = cheapestWay(ways, target, worse);
        tell(std::to_string(solution.geometry.patches.size()) + " patches, " + describe(solution.way));
        solution.radiosity = solveBy(solution.way, solution.geometry, solution.surfaces, scatterings, effects);
    }

    void estimate() {
        tell("estimating the error");
        ErrorEstimateOptions options;
        options.occlusion = effects.has(Effect::occlusion);
        options.rays = static_cast<std::size_t>(std::clamp(std::pow(8e-3 / goal.error, 2.0), 16.0, 1024.0));
        if (solution.way.specularRays > 0) {
            options.scatterings = scatterings;
            options.specularRays = times * solution.way.specularRays;
        }
        solution.solverError = estimateError(solution.geometry, solution.surfaces, solution.radiosity, options);
        solution.meshError = estimateMeshError(*solution.mesh, solution.radiosity);
        solution.error =
            margin * (chosenMesh() ? std::hypot(solution.meshError, solution.solverError) : solution.solverError);
        solution.reached = solution.error <= goal.error;
    }

    // The mesh becomes finer where it errs too much, in proportion; else the next way is chosen by how much this one disappointed.
    void adjust() {
        const double forMesh = std::sqrt(1.0 - ofSolver * ofSolver) * goal.error / margin;
        if (chosenMesh() && solution.meshError > forMesh) {
            const double aimedAt = std::isfinite(solution.meshError) ? forMesh / solution.meshError : 0.5;
            solution.patchSize *= std::clamp(0.85 * aimedAt, 0.2, 0.85);
            solution.mesh.reset();
        }
        if (solution.solverError > solution.way.error)
            worse = std::max(worse, solution.solverError / solution.way.error);
        else if (!chosenMesh() || solution.meshError <= forMesh)
            worse *= 1.5;
    }

    const Scene& scene;
    const Effects& effects;
    const ErrorGoal& goal;
    const std::vector<Scattering> scatterings;
    AccurateSolution solution;
    std::vector<Way> ways;
    double worse = 1.0;  // than the table says, as far as was seen
};

}  // namespace

AccurateSolution solveToError(const Scene& scene, const Effects& effects, const ErrorGoal& goal) {
    const Stopwatch watch;
    AccurateSolution solution = Search(scene, effects, goal).run();
    solution.seconds = watch.seconds();
    return solution;
}

}  // namespace radlab::engine
