#pragma once

#include <array>
#include <vector>

#include "engine/Polygon.h"

namespace radlab::engine {

using Triangle = std::array<Point, 3>;

/// A polygon in convex pieces, turned as it is; itself where it is convex, and nothing where it has no area.
///
/// @pre no two of its edges cross
std::vector<Polygon> convexPiecesOf(const Polygon& polygon);

/// The triangles of a polygon, turned as it is, convex or not; those without area are left out.
///
/// @pre no two of its edges cross
std::vector<Triangle> trianglesOf(const Polygon& polygon);

/// A point of a polygon for two numbers from 0 to 1: where these are spread evenly, the points are.
class AreaSampler {
public:
    explicit AreaSampler(const Polygon& polygon);
    Point at(double u, double v) const;

private:
    std::vector<Triangle> triangles;
    std::vector<double> upTo;  // the share of the area up to and with each triangle
};

}  // namespace radlab::engine
