#pragma once

#include <vector>

#include "course/DataFormat.h"

namespace radlab {

/// Depths between which a view sees the scene.
struct ViewDepth {
    double nearest;
    double farthest;
};

/// Where to put the near and far plane of views from a patch's centre, so that nothing before it is lost.
///
/// nearest is half the distance from eye to the closest patch that rises over the plane through eye, since a point at
/// distance d lies at least d/√3 deep in one of a hemicube's five views; at least 1e-6 of farthest.
///
/// @param direction unit normal of that plane
/// @return 1e-3 and 1e3 where there are no patches
/// @cost linear in the number of patches
ViewDepth viewDepth(const std::vector<MyPolygon*>& patches, const std::vector<MyVertex*>& corners,
                    const glm::dvec3& eye, const glm::dvec3& direction);

}  // namespace radlab
