#pragma once

#include <vector>

#include "course/PatchMesh.h"
#include "engine/Geometry.h"
#include "engine/Radiosity.h"
#include "engine/TracedScene.h"
#include "scene/Scene.h"

namespace radlab::study {

/// A scene cut into patches, its surfaces all taken as matt and opaque.
struct StudyMesh {
    /// @pre the scene outlives this
    /// Errors: those of the Mesher.
    StudyMesh(const Scene& scene, double patchSize);

    /// What rays meet.
    engine::TracedScene traced() const;

    const Scene& scene;
    double patchSize;
    PatchMesh mesh;
    engine::Geometry geometry;
    engine::Surfaces surfaces;
    bool occlusion;  ///< whether anything may hide anything
};

}  // namespace radlab::study
