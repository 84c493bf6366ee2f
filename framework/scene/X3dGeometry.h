#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "base/Error.h"
#include "scene/X3dNode.h"

namespace radlab {

/// The points of a Coordinate node, in the system of its geometry.
using X3dPoints = std::vector<glm::dvec3>;

/// A geometry node before it is placed in the world.
struct X3dGeometry {
    std::shared_ptr<const X3dPoints> points;
    std::vector<std::vector<int>> faces;  ///< indices into points, counter-clockwise seen from the front
    std::size_t corners = 0;              ///< of all faces together
    int flattened = 0;                    ///< faces left out, since they repeat corners until fewer than 3 are left
    bool twoSided = false;                ///< solid="false"
    float creaseAngle = 0.0f;             ///< radians
    Location where;
};

/// The points of a Coordinate.
///
/// @throws Error where the numbers do not come in threes
std::shared_ptr<const X3dPoints> readCoordinate(const X3dNode& node);

/// The faces of an IndexedFaceSet, IndexedTriangleSet or IndexedQuadSet.
///
/// With ccw="false" the corners are turned round, so that front is front. A corner that repeats the one before
/// it is merged with it; a face that this leaves with fewer than 3 is left out and counted.
///
/// @throws Error for an index without a point, and for index lists of the wrong length
/// @cost   one pass over the indices
X3dGeometry readGeometry(const X3dNode& node, std::shared_ptr<const X3dPoints> points);

}  // namespace radlab
