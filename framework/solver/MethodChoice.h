#pragma once

#include "scene/Effects.h"
#include "scene/ResourceFile.h"
#include "scene/Scene.h"

namespace radlab {

/// How the form factors of a scene are found: the settings' method, and for `automatic` the cheaper one that is right.
///
/// @return analytic where no face can hide a part of another, hemicube elsewhere; never automatic
FormFactorMethod formFactorMethod(const Resource& resource, const Scene& scene);

/// The same where the scene's effects are known already.
FormFactorMethod formFactorMethod(FormFactorMethod wanted, const Effects& effects);

}  // namespace radlab
