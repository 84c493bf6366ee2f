#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "engine/PatchShading.h"
#include "scene/Scene.h"

namespace radlab {

/// A corner of a solved mesh.
struct MeshVertex {
    Vec3f position{0.0f};   ///< in the scene's unit
    Vec3f color{0.0f};      ///< linear and ready for display: exposure times radiance, 0 to 1
    Vec3f radiosity{0.0f};  ///< B in W/m² per channel
};

/// A patch of a solved mesh.
struct MeshPatch {
    std::array<std::uint32_t, 4> vertex{};  ///< indices of the part's vertices, counter-clockwise seen from the front
    int vertices = 0;                       ///< 3 or 4
    Vec3f radiosity{0.0f};                  ///< B in W/m² per channel
};

/// What is made of one material.
struct MeshPart {
    std::shared_ptr<const Material> material;
    bool twoSided = false;
    std::vector<MeshVertex> vertices;
    std::vector<MeshPatch> patches;
};

/// A solved scene as other programs take it.
struct SolvedMesh {
    std::vector<MeshPart> parts;  ///< in the order of their first patches
    std::vector<Camera> cameras;
    float exposure = 1.0f;  ///< display value per radiance
};

/// The mesh of a solution, a part for each material, coloured as the picture of that shading and exposure is.
///
/// Patches share vertices where the shading is smooth; flat patches, and those at either side of a crease, have vertices of
/// their own.
///
/// @param mesh      that was cut from the scene and solved
/// @param radiosity B of each patch, W/m² per channel
/// @param shading   of the same mesh
/// @param exposure  display value per radiance, > 0
SolvedMesh solvedMesh(const Scene& scene, const PatchMesh& mesh, const std::vector<engine::Point>& radiosity,
                      const engine::PatchShading& shading, float exposure);

}  // namespace radlab
