#pragma once

#include <functional>
#include <memory>

#include "course/PatchMesh.h"
#include "engine/Ways.h"

namespace radlab::engine {

/// How many solutions are tried, at most.
constexpr int mostTries = 6;

/// A solution that is as accurate as it was asked to be.
struct AccurateSolution {
    double patchSize = 0.0;
    std::unique_ptr<PatchMesh> mesh;
    Geometry geometry;
    Surfaces surfaces;
    std::vector<Point> radiosity;  ///< W/m² per channel
    Way way;                       ///< by which it was found
    double meshError = 0.0;        ///< estimated: of one radiosity a patch
    double solverError = 0.0;      ///< estimated: of the radiosities on this mesh
    double error =
        0.0;  ///< estimated, both together with a margin; the solver's alone where the patches' size was given
    bool reached = false;  ///< whether that is at most what was asked for
    bool stopped = false;  ///< by Ctrl-C: this is the last try that was finished
    double seconds = 0.0;  ///< with all that was tried and estimated
};

struct ErrorGoal {
    double error = 0.01;     ///< RMS of the error over RMS of the radiosity, both weighted by area; 1e-4 to 1
    double patchSize = 0.0;  ///< 0: chosen, too
    std::function<void(double tries, const std::string& what)>
        progress;  ///< told how many tries are done, and what is being done
};

/// Solves a scene to an accuracy, by the cheapest way and on the coarsest mesh that reach it.
///
/// Takes the way that promises the error for the least time, estimates what came out (estimateError, estimateMeshError), and
/// takes another way or a finer mesh while the estimate is above the goal. Estimates of the error were found to be low by a factor of
/// 1.6 at most, and count that much more.
///
/// @return the last solution tried, mostTries at most
/// @cost   a few solutions, and estimates that cost as much as a coarse one
/// Errors: those of the Mesher and the solvers; Interrupted before the first try is finished.
AccurateSolution solveToError(const Scene& scene, const Effects& effects, const ErrorGoal& goal);

}  // namespace radlab::engine
