#pragma once

#include "engine/Polygon.h"

namespace radlab::engine {

/// F(from→to) with both polygons taken as small against their distance, as calcAnalyticalFF does.
///
/// @return no unit, >= 0, and without bound where the polygons come near; 0 where the centres coincide
/// @source [CohenWallace1993, chapter 4]
double pointToPoint(const Polygon& from, const Polygon& to);

/// F(dA→polygon) from a point of a surface: the polygon whole, the surface small.
///
/// Nothing is hidden. The polygon is seen from its front alone, and clipped by the surface's horizon.
///
/// @param normal  unit normal of the surface at the point
/// @return 0 to 1; 0 for a point in the polygon's plane, also on the polygon itself
/// @cost one arc tangent for each edge; Gauss-Legendre nodes for polygons farther than 100 of their radii, where the sum over
///       the edges would cancel
/// @source [Lambert1760]; [CohenWallace1993, chapter 4]
double pointToPolygon(const Point& point, const Point& normal, const Polygon& polygon);

/// The same for a polygon that lies wholly above the horizon and is near: the plain sum over its edges.
double lambertSum(const Point& point, const Point& normal, const Polygon& polygon);

}  // namespace radlab::engine
