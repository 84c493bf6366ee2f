#pragma once

// Scenes for the benchmarks of the engine.

#include <string>

#include "engine/Geometry.h"
#include "scene/X3dReader.h"

namespace radlab::engine {

/// A scene of the project, cut into about so many patches.
struct Setting {
    Setting(const char* name, double patches)
        : scene(readX3d(std::string(RADLAB_SOURCE_DIR "/resources/scenes/") + name)),
          size(static_cast<float>(patchSizeFor(scene, patches))),
          mesh(scene.vertices, scene.faces, size, size),
          geometry(geometryOf(scene, mesh)) {}

    Scene scene;
    float size;
    PatchMesh mesh;
    Geometry geometry;
};

}  // namespace radlab::engine
