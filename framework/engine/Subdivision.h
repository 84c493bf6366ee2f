#pragma once

#include <memory>
#include <vector>

#include "course/PatchMesh.h"
#include "engine/Geometry.h"
#include "engine/Radiosity.h"

namespace radlab::engine {

/// A mesh whose patches each lie in one patch of a coarser mesh.
struct Subdivision {
    std::unique_ptr<PatchMesh> mesh;
    Geometry geometry;  ///< with the scene's faces
    Surfaces surfaces;
    std::vector<std::size_t> coarseOf;  ///< for each patch the coarse one that it lies in
};

/// Cuts every patch of a mesh into about splits x splits patches, which share their vertices all over a face.
///
/// @param patchSize  that the mesh was cut with
Subdivision subdivide(const Scene& scene, const PatchMesh& mesh, double patchSize, double splits);

/// The error of one radiosity for each coarse patch, held against those of a subdivision.
///
/// @return as relativeError of RelativeError.h
double relativeError(const std::vector<Point>& found, const Subdivision& fine, const std::vector<Point>& truth);

}  // namespace radlab::engine
