#pragma once

#include <cstddef>
#include <vector>

#include "course/PatchMesh.h"
#include "engine/Polygon.h"
#include "scene/Scene.h"

namespace radlab::engine {

/// The shapes of a scene in doubles: its patches, and the faces that they were cut from.
struct Geometry {
    std::vector<Polygon> patches;
    std::vector<Polygon> faces;
    std::vector<std::size_t> faceOf;  ///< for each patch
    std::vector<double> through;      ///< for each face: the share of light that passes straight on; empty: none does

    double throughPatch(std::size_t patch) const { return through.empty() ? 0.0 : through[faceOf[patch]]; }
};

/// The length of a patch's edge at which a scene falls into about so many patches.
double patchSizeFor(const Scene& scene, double patches);

/// About how many patches a scene falls into at that length of their edges.
double patchesAt(const Scene& scene, double patchSize, double lightSize);

/// The areas of the patches.
std::vector<double> areasOf(const Geometry& geometry);

/// The patches of a mesh and the faces of its scene.
///
/// @pre the mesh was cut from this scene
Geometry geometryOf(const Scene& scene, const PatchMesh& mesh);

/// The faces themselves as the patches, in the file's order.
Geometry geometryOf(const Scene& scene);

}  // namespace radlab::engine
