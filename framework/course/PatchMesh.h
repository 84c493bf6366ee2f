#pragma once

#include <vector>

#include "course/DataFormat.h"
#include "course/Face.h"

namespace radlab {

/// How many patches 24-bit patch IDs can tell apart: 2^24, less the background and one to spare.
constexpr std::size_t mostPatches = (std::size_t{1} << 24) - 2;

/// The patches of a scene and the vertices that they share; owner of what the course's globals point to.
class PatchMesh {
public:
    PatchMesh() = default;

    /// Cuts the faces into patches with the Mesher.
    ///
    /// @param patchSize  length of a patch's edge to aim at, in the scene's unit, > 0
    /// @param lightSize  the same for faces that emit
    /// Errors: those of Mesher::mesh, and faces that leave no patch.
    PatchMesh(const std::vector<Vec3f>& positions, const std::vector<Face>& faces, float patchSize, float lightSize);

    ~PatchMesh();
    PatchMesh(const PatchMesh&) = delete;
    PatchMesh& operator=(const PatchMesh&) = delete;

    /// Points the course's globals `polygons` and `vertices` at this mesh, until it goes or another is published.
    ///
    /// Errors: more patches than the 16,777,214 that 24 bits of patch ID can tell apart.
    void publish();

    /// Puts every patch back to before the first shot: rad = unshot_rad = emissive, formF = 0, colours 0.
    void reset();

    std::vector<MyPolygon> patches;
    std::vector<MyVertex> corners;
    std::vector<int> faceOf;  ///< for each patch the index of the face that it was cut from
};

}  // namespace radlab
