#pragma once

#include <string>

#include "course/PatchMesh.h"
#include "engine/FormFactors.h"
#include "engine/Geometry.h"
#include "scene/Scene.h"

namespace radlab {

/// One of the project's scenes, cut into patches, as the handout's figures need it.
struct HandoutScene {
    /// @param name  of a file in resources/scenes, without its ending
    HandoutScene(const std::string& name, float patchSize);

    Scene scene;
    PatchMesh mesh;
    engine::Geometry geometry;
};

/// The options of one method for a scene in which things may be hidden.
engine::FormFactorOptions handoutMethod(engine::Method method, std::size_t rays = 0, int hemicubeSize = 256);

/// A square of edge 1 around a centre.
///
/// @param right, up  unit vectors along its edges; its normal is their cross product
engine::Polygon unitSquare(const engine::Point& center, const engine::Point& right, const engine::Point& up);

}  // namespace radlab
