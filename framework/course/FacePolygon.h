#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "course/Face.h"

namespace radlab {

using Corners = std::vector<glm::dvec3>;
using Polygon2 = std::vector<glm::dvec2>;

/// The largest distance between two corners.
double diameter(const Corners& corners);

/// The length below which float coordinates of that size cannot tell places apart.
double floatResolution(const Corners& corners);

/// Whether a polygon of that area is thinner than what float coordinates of its size and place can tell apart.
bool hasNoArea(const Corners& corners, double area);

/// How far a point is from a straight edge, its ends included.
double distanceToSegment(const glm::dvec3& point, const glm::dvec3& begin, const glm::dvec3& end);

/// An axis that is far from parallel to a unit vector, to cross it with: x, or y where the vector is near x.
glm::dvec3 axisAcross(const glm::dvec3& direction);

/// The area vector of a closed polygon: normal times area, counter-clockwise positive.
glm::dvec3 areaVector(const Corners& corners);

/// Centroid of the area of a planar polygon with the given unit normal, convex or not.
///
/// @pre the area is not 0
glm::dvec3 areaCentroid(const Corners& corners, const glm::dvec3& normal);

/// Signed area of a polygon in the plane, counter-clockwise positive.
double signedArea(const Polygon2& polygon);

/// Whether every corner turns left (or runs straight on), within a relative tolerance of 1e-9.
///
/// @pre counter-clockwise
bool isConvex(const Polygon2& polygon);

/// Joins polygons that share an edge as long as what comes out stays convex, and drops corners that run straight on.
///
/// @pre shared corners are equal to the bit
std::vector<Polygon2> mergedWhereConvex(const std::vector<Polygon2>& polygons);

/// Cuts a simple polygon into convex ones along its diagonals, by ear clipping and merging back
/// what stays convex.
///
/// @pre    counter-clockwise
/// @return convex polygons whose corners are corners of the polygon; their areas add up to its area
/// @cost   cubic in the number of corners in the worst case
std::vector<Polygon2> convexPieces(const Polygon2& polygon);

/// The part of a convex polygon on the kept side of an axis-parallel line.
///
/// @param axis 0 for the line x = limit, 1 for y = limit
/// @param keepBelow keeps coordinates <= limit, otherwise >= limit
/// @source [SutherlandHodgman1974]
Polygon2 clipAtLine(const Polygon2& polygon, int axis, double limit, bool keepBelow);

}  // namespace radlab
