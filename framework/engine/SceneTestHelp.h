#pragma once

// Scenes of the project, cut into patches.

#include <string>

#include "engine/Geometry.h"
#include "engine/Radiosity.h"
#include "engine/RelativeError.h"
#include "scene/X3dReader.h"

namespace radlab::engine {

struct CutScene {
    CutScene(const std::string& file, double patchSize)
        : scene(readX3d(RADLAB_SOURCE_DIR "/resources/scenes/" + file)),
          mesh(scene.vertices, scene.faces, static_cast<float>(patchSize), static_cast<float>(patchSize)),
          geometry(geometryOf(scene, mesh)),
          surfaces(surfacesOf(mesh)) {}

    double relativeError(const std::vector<Point>& found, const std::vector<Point>& truth) const {
        return engine::relativeError(areasOf(geometry), found, truth);
    }

    Scene scene;
    PatchMesh mesh;
    Geometry geometry;
    Surfaces surfaces;
};

}  // namespace radlab::engine
