#pragma once

#include <memory>
#include <string>
#include <vector>

#include "course/PatchMesh.h"
#include "engine/Geometry.h"
#include "engine/Scattering.h"
#include "scene/Effects.h"
#include "scene/Scene.h"

namespace CLI {
class App;
}

namespace radlab {

/// What a program was told of the scene to work on.
struct SceneFlags {
    std::string file;                ///< X3D, or settings (Resource.xml) that name it
    double patchSize = 0.0;          ///< 0: as the settings say, or by the number of patches
    double patches = 1000.0;         ///< about how many, where no size is given
    std::vector<std::string> force;  ///< EFFECT=on or EFFECT=off
};

/// Adds SCENE, --patch-size and --force to a program's flags.
void addSceneFlags(CLI::App& app, SceneFlags& flags);

/// A scene, cut into patches, and the effects that it calls for or the user demands.
struct SceneInput {
    Scene scene;
    std::unique_ptr<PatchMesh> mesh;
    engine::Geometry geometry;
    Effects effects;
    std::vector<engine::Scattering> scatterings;  ///< of each face, without the effects that are off
    std::string summary;                          ///< file and patches, in a line
};

/// Errors: those of forceNamed, the readers and the Mesher.
SceneInput readSceneInput(const SceneFlags& flags);

/// The same with the scene's faces as the patches, and no mesh.
SceneInput readFacesInput(const SceneFlags& flags);

}  // namespace radlab
