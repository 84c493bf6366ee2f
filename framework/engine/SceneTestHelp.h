#pragma once

// Scenes of the project, cut into patches.

#include <cmath>
#include <string>

#include "engine/Geometry.h"
#include "engine/Radiosity.h"
#include "scene/X3dReader.h"

namespace radlab::engine {

struct CutScene {
    CutScene(const std::string& file, double patchSize)
        : scene(readX3d(RADLAB_SOURCE_DIR "/resources/scenes/" + file)),
          mesh(scene.vertices, scene.faces, static_cast<float>(patchSize), static_cast<float>(patchSize)),
          geometry(geometryOf(scene, mesh)),
          surfaces(surfacesOf(mesh)) {}

    /// The RMS of the difference over the RMS of the truth, both weighted by area.
    double relativeError(const std::vector<Point>& found, const std::vector<Point>& truth) const {
        double error = 0.0, all = 0.0;
        for (std::size_t i = 0; i < truth.size(); ++i) {
            const Point off = found[i] - truth[i];
            error += geometry.patches[i].area * glm::dot(off, off);
            all += geometry.patches[i].area * glm::dot(truth[i], truth[i]);
        }
        return std::sqrt(error / all);
    }

    Scene scene;
    PatchMesh mesh;
    Geometry geometry;
    Surfaces surfaces;
};

}  // namespace radlab::engine
