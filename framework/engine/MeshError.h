#pragma once

#include <vector>

#include "course/PatchMesh.h"
#include "engine/Polygon.h"

namespace radlab::engine {

/// How far the light on patches is from one value a patch: the error of the mesh, not of the solution on it.
///
/// Light is taken to change evenly from each patch to those that share an edge with it: within a patch it then deviates from its mean
/// by 1/√12 of the difference, in each of two directions. Patches that share no edge with another are taken to vary as the
/// others do.
///
/// @param radiosity of the mesh's patches, W/m²
/// @return RMS of the error over RMS of the radiosity, both weighted by area, the channels added up; infinite where no
///         two patches share an edge, 0 for a black scene
/// @cost   n log n in the number of patches
double estimateMeshError(const PatchMesh& mesh, const std::vector<Point>& radiosity);

}  // namespace radlab::engine
