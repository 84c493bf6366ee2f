#pragma once

#include "apps/RenderSolution.h"

namespace radlab {

/// Solves a scene to a relative error, by a way and on patches that the engine chooses; the input gets these patches.
///
/// @param error      RMS of the error over RMS of the radiosity
/// @param patchSize  0: chosen, too
/// Errors: a scene that mirrors or is transparent, for which errors are not estimated.
RenderSolution solveToError(SceneInput& input, double error, double patchSize);

/// Solves a scene by links between clusters of patches, with a progress line.
///
/// @param threshold a link that carries a larger share of the light is refined
RenderSolution solveByLinks(const SceneInput& input, double threshold);

}  // namespace radlab
