#pragma once

#include "scene/Placement.h"
#include "scene/Scene.h"
#include "scene/X3dNode.h"

namespace radlab {

/// The camera of a Viewpoint node, in world coordinates.
///
/// Its name is the description, or else the DEF name. Where the placement shears, up is turned back to a right
/// angle with the direction.
///
/// @throws Error for wrong fields, a field of view outside 0 to π, and a placement that loses the direction
/// @source [X3D, section 23.4.6] Viewpoint
Camera readViewpoint(const X3dNode& node, const Placement& placement);

}  // namespace radlab
