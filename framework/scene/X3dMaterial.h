#pragma once

#include "course/Face.h"
#include "scene/X3dNode.h"

namespace radlab {

/// The material that a Material node describes; colours are taken as linear RGB.
///
/// Emission may be above 1: it is a radiosity in W/m². X3D's defaults stand in for what is not given.
///
/// @throws Error for a diffuse or specular colour, shininess or transparency outside 0 to 1, and for an
///         emission that is negative
/// @source [X3D, section 12.4.4] Material
Material readMaterial(const X3dNode& node);

}  // namespace radlab
