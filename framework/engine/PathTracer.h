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
    std::size_t samples = 0;           ///< paths from each patch that reflects
    std::size_t rays = 0;
};

struct PathRadiosityOptions {
    std::size_t samples = 1024;    ///< paths from each patch, rounded up to a multiple of 32
    bool constantPatches = false;  ///< solve B = E + ρ·F·B, as radiosity does, in place of the true light
    Progress progress;             ///< counts patches
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
/// @return unbiased; 0 is the standard error where nothing is reflected
/// @cost   a path for each sample, of 1/(1-ρ) bounces or fewer with two rays each; on all cores, the same to the bit
///         for any number of threads
/// Errors: those of PathWalk.
/// @source [Kajiya1986]; [CranleyPatterson1976] random shifts
PathRadiosity pathTraceRadiosity(const TracedScene& scene, const PathRadiosityOptions& options = {});

/// The picture of a scene by path tracing, in the frame of drawPicture and with its view of fronts and backs.
///
/// @param samples paths for each pixel, 1 or more
/// @return linear radiance, width x height; unbiased, nothing is clamped
/// @cost   as pathTraceRadiosity, for each pixel in place of a patch; progress counts tiles
/// Errors: those of PathWalk.
/// @source [Kajiya1986]
Image pathTracePicture(const TracedScene& scene, const Frame& frame, std::size_t samples,
                       const Progress& progress = {});

}  // namespace radlab::engine
