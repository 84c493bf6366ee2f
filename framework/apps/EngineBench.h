#pragma once

// Scenes for the benchmarks of the engine.

#include <cmath>
#include <string>

#include "engine/Geometry.h"
#include "scene/X3dReader.h"

namespace radlab::engine {

/// A scene of the project, cut into patches.
struct Setting {
    Setting(const char* scene, float patchSize)
        : Setting(readX3d(std::string(RADLAB_SOURCE_DIR "/resources/scenes/") + scene), patchSize) {}
    Setting(const Scene& scene, float size)
        : mesh(scene.vertices, scene.faces, size, size), geometry(geometryOf(scene, mesh)) {}

    PatchMesh mesh;
    Geometry geometry;
};

/// The size of the patches that cuts the Cornell box with blocks into about the wanted number.
inline float sizeFor(double patches) {
    const Setting coarse("cornell_2.x3d", 100.0f);
    double area = 0.0;
    for (const Polygon& patch : coarse.geometry.patches) area += patch.area;
    return static_cast<float>(std::sqrt(area / patches));
}

}  // namespace radlab::engine
