#pragma once

#include <vector>

#include "base/Image.h"
#include "engine/CameraRays.h"
#include "engine/Parallel.h"
#include "engine/TracedScene.h"

namespace radlab::engine {

/// Radiosities by path tracing, with what they are worth.
struct PathRadiosity {
    std::vector<Point> radiosity;      ///< of each patch, W/m² per channel
    std::vector<Point> standardError;  ///< of each radiosity
    std::size_t samples = 0;           ///< paths from each patch that reflects, at least
    std::size_t rays = 0;
};

/// How many paths a patch takes where so many are asked for: a multiple of 32.
std::size_t pathsOf(std::size_t samples);

struct PathRadiosityOptions {
    std::size_t samples = 1024;    ///< paths from each patch, rounded up by pathsOf
    bool constantPatches = false;  ///< solve B = E + ρ·F·B, as radiosity does, in place of the true light
    Progress progress;             ///< counts paths, those of all patches together
};

/// The radiosity of every patch, as the mean of random walks from points spread over it.
///
/// An answer of its own to what the form factors answer: it knows no form factors and no system of equations. Specular
/// and transparent materials are followed. The samples of a patch are 32 replicates of a low-discrepancy sequence, each
/// shifted by random numbers of its own, so that the replicates are independent and their spread gives the standard
/// error; beyond the first bounce all numbers are random.
///
/// With constantPatches, a path that meets a patch goes on from another point of it, chosen evenly: then what it meets
/// has one radiosity all over, and the answer is that of the matrix of form factors, up to the standard error alone.
///
/// Patches take their paths by turns, a few at a time: Ctrl-C leaves what there is of all of them, some having had a turn more.
///
/// @return unbiased; 0 is the standard error where nothing is reflected
/// @cost   a path for each sample, of 1/(1-ρ) bounces or fewer with two rays each; on all cores, the same to the bit
///         for any number of threads; 0.8 kB for each patch
/// Errors: those of PathWalk; Interrupted where not every patch has had a turn.
/// @source [Kajiya1986]; [CranleyPatterson1976] random shifts
PathRadiosity pathTraceRadiosity(const TracedScene& scene, const PathRadiosityOptions& options = {});

/// The picture of a scene by path tracing, in the frame of drawPicture and with its view of fronts and backs.
///
/// Pixels take turns as patches do.
///
/// @param samples paths for each pixel, 1 or more
/// @param fewest  set to how many each has got: fewer where Ctrl-C ended it
/// @return linear radiance, width x height; unbiased, nothing is clamped
/// @cost   as pathTraceRadiosity, for each pixel in place of a patch; progress counts paths, those of all pixels together
/// Errors: those of PathWalk; Interrupted where not every pixel has had a turn.
/// @source [Kajiya1986]
Image pathTracePicture(const TracedScene& scene, const Frame& frame, std::size_t samples, const Progress& progress = {},
                       std::size_t* fewest = nullptr);

}  // namespace radlab::engine
