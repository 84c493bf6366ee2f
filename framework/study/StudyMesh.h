#pragma once

#include <vector>

#include "course/PatchMesh.h"
#include "engine/Geometry.h"
#include "engine/Radiosity.h"
#include "engine/TracedScene.h"
#include "scene/Scene.h"

namespace radlab::study {

/// The length of a patch's edge at which a scene falls into about so many patches.
double patchSizeFor(const Scene& scene, double patches);

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

/// The same faces, each patch cut on, for a solution that is better than any on the patches.
struct FineMesh {
    /// @param splits of a patch's edge, 1 or more
    FineMesh(const StudyMesh& coarse, double splits);

    PatchMesh mesh;  ///< its faceOf says in which coarse patch a patch lies
    engine::Geometry geometry;
    engine::Surfaces surfaces;
};

}  // namespace radlab::study
