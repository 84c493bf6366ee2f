#include "engine/SolveToError.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "base/Interrupts.h"
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

// A mesh to solve on.
struct Cut {
    double patchSize = 0.0;
    std::unique_ptr<PatchMesh> mesh;
    Geometry geometry;
    Surfaces surfaces;
};

// What a try found on a mesh.
struct Found {
    Way way;
    std::vector<Point> radiosity;
    double meshError = 0.0, solverError = 0.0, error = 0.0;
};

class Search {
public:
    Search(const Scene& asked, const Effects& found, const ErrorGoal& wanted)
        : scene(asked), effects(found), goal(wanted), scatterings(scatteringsOf(asked, found)) {
        cut.patchSize = chosenMesh() ? firstSize(scene, goal.error) : goal.patchSize;
    }

    AccurateSolution run() {
        const bool whole = doneWhole([&] {
            for (; tries < mostTries && !isReached(); ++tries) {
                if (last) adjust();
                if (!cut.mesh) makeCut();
                Found made = solved();
                estimate(made);
                if (solvedOn.mesh) solvedOn = {};
                last = std::move(made);
            }
        });
        if (!last) throw Interrupted();
        Cut& on = solvedOn.mesh ? solvedOn : cut;
        return {on.patchSize,
                std::move(on.mesh),
                std::move(on.geometry),
                std::move(on.surfaces),
                std::move(last->radiosity),
                last->way,
                last->meshError,
                last->solverError,
                last->error,
                isReached(),
                !whole};
    }

private:
    bool chosenMesh() const { return goal.patchSize == 0.0; }
    bool isReached() const { return last && last->error <= goal.error; }

    // share is how much of the try is done.
    void tell(double share, const std::string& what) const {
        if (goal.progress) goal.progress(tries + share, what);
    }

    void makeCut() {
        tell(0.0, "cutting patches");
        const auto size = static_cast<float>(cut.patchSize);
        auto mesh = std::make_unique<PatchMesh>(scene.vertices, scene.faces, size, size);
        cut.geometry = geometryOf(scene, *mesh);
        cut.geometry.through = throughOf(scatterings);
        cut.surfaces = surfacesOf(*mesh, scatterings);
        ways = waysFor(workOf(scene, cut.geometry, {}), effects);
        cut.mesh = std::move(mesh);
    }

    Found solved() const {
        const double target = (chosenMesh() ? ofSolver : 1.0) * goal.error / margin;
        Found made;
        made.way = cheapestWay(ways, target, worse);
        tell(0.1, std::to_string(cut.geometry.patches.size()) + " patches, " + describe(made.way));
        made.radiosity = solveBy(made.way, cut.geometry, cut.surfaces, scatterings, effects);
        Interrupts::check();  // or it may have been cut short
        return made;
    }

    void estimate(Found& made) const {
        tell(0.5, "estimating the error");
        ErrorEstimateOptions options;
        options.occlusion = effects.has(Effect::occlusion);
        options.rays = static_cast<std::size_t>(std::clamp(std::pow(8e-3 / goal.error, 2.0), 16.0, 1024.0));
        if (made.way.specularRays > 0) {
            options.scatterings = scatterings;
            options.specularRays = times * made.way.specularRays;
        }
        made.solverError = estimateError(cut.geometry, cut.surfaces, made.radiosity, options);
        made.meshError = estimateMeshError(*cut.mesh, made.radiosity);
        made.error = margin * (chosenMesh() ? std::hypot(made.meshError, made.solverError) : made.solverError);
    }

    // The mesh becomes finer where it errs too much, in proportion; else the next way is chosen by how much this one disappointed.
    void adjust() {
        const double forMesh = std::sqrt(1.0 - ofSolver * ofSolver) * goal.error / margin;
        const bool finer = chosenMesh() && last->meshError > forMesh;
        if (last->solverError > last->way.error)
            worse = std::max(worse, last->solverError / last->way.error);
        else if (!finer)
            worse *= 1.5;
        if (!finer) return;
        const double aimedAt = std::isfinite(last->meshError) ? forMesh / last->meshError : 0.5;
        solvedOn = std::move(cut);
        cut = {};
        cut.patchSize = solvedOn.patchSize * std::clamp(0.85 * aimedAt, 0.2, 0.85);
    }

    const Scene& scene;
    const Effects& effects;
    const ErrorGoal& goal;
    const std::vector<Scattering> scatterings;
    Cut cut, solvedOn;          // the mesh at hand; that of the last try, where it is another one
    std::optional<Found> last;  // try that was finished
    std::vector<Way> ways;
    int tries = 0;
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
