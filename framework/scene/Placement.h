#pragma once

#include <glm/glm.hpp>

#include "course/Vec3f.h"
#include "scene/X3dNode.h"

namespace radlab {

/// How a coordinate system stands in another one.
struct Placement {
    glm::dmat4 matrix{1.0};
    bool mirrored = false;  ///< an odd number of negative scales: the determinant is negative, and corners turn round

    Placement operator*(const Placement& inner) const { return {matrix * inner.matrix, mirrored != inner.mirrored}; }
};

/// The rotation by an angle about an axis of any length but 0.
///
/// @param angle radians, by the right-hand rule
/// @source Rodrigues' formula
glm::dmat3 rotationAbout(const glm::dvec3& axis, double angle);

/// The rotation that a field holds: an axis and an angle in radians.
///
/// @throws Error for an axis of length 0 with an angle other than 0
glm::dmat3 readRotation(const X3dNode& node, const char* field);

/// The placement that a Transform gives to its children: T C R SR S -SR -C.
///
/// @throws Error for wrong fields and a scale of 0, which would flatten the children
/// @source [X3D, section 10.4.4] Transform
Placement readTransform(const X3dNode& node);

/// A point in the outer system; coordinates may be infinite where they are too large for a float.
Vec3f placed(const Placement& placement, const glm::dvec3& point);

/// Whether all coordinates are finite.
bool isFinite(const Vec3f& v);

}  // namespace radlab
