#pragma once

#include <string>
#include <vector>

#include "apps/RenderPicture.h"
#include "apps/RenderSolution.h"

namespace radlab {

/// A scene rendered with the effects that it calls for, but for those that were forced.
struct EffectRun {
    /// @param about  how many patches to cut the scene into
    /// @param force  EFFECT=on or EFFECT=off
    EffectRun(const std::string& file, double about, const std::vector<std::string>& force);

    SceneInput input;
    RenderSolution solution;
    RenderPicture picture;
    double seconds = 0.0;  ///< for form factors, radiosities and picture
};

/// The scenes of the project, by the paths of their files.
std::vector<std::string> projectScenes();

}  // namespace radlab
