#pragma once

#include "scene/ResourceFile.h"
#include "scene/Scene.h"

namespace radlab {

/// How the form factors of a scene are found: the settings' method, and for `automatic` the cheaper one that is right.
///
/// @return analytic where no face can hide a part of another, hemicube elsewhere; never automatic
FormFactorMethod formFactorMethod(const Resource& resource, const Scene& scene);

}  // namespace radlab
