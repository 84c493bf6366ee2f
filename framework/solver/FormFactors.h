#pragma once

#include "scene/ResourceFile.h"
#include "scene/Scene.h"
#include "solver/Progressive.h"

namespace radlab {

/// How the form factors of a scene are found: the settings' method, and for `automatic` the cheaper one that is right.
///
/// @return analytic where no face can hide a part of another, hemicube elsewhere; never automatic
FormFactorMethod formFactorMethod(const Resource& resource, const Scene& scene);

/// The course's function for a method: calcAnalyticalFF, or calcFF on a hemicube of the given size.
///
/// @pre method is not automatic; for the hemicube a GlContext is current, as long as the result lives
Progressive::FormFactors formFactorsBy(FormFactorMethod method, int hemicubeSize);

}  // namespace radlab
