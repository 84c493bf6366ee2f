#pragma once

#include "apps/RenderSolution.h"

namespace radlab {

/// Solves a scene to a relative error, by a way and on patches that the engine chooses; the input gets these patches.
///
/// @param error      RMS of the error over RMS of the radiosity
/// @param patchSize  0: chosen, too
RenderSolution solveToError(SceneInput& input, double error, double patchSize);

}  // namespace radlab
