#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include <glm/glm.hpp>

namespace radlab::engine {

using Point = glm::dvec3;

/// A flat polygon, counter-clockwise seen from its front; convex or not.
struct Polygon {
    Polygon() = default;

    /// @param outline at least 3 corners; fewer, or corners on one line, leave no area
    explicit Polygon(std::vector<Point> outline);

    std::vector<Point> corners;
    Point normal{0.0};    ///< unit normal of the front, 0 where there is no area
    Point center{0.0};    ///< centroid of the area
    double area = 0.0;    ///< in squared units of the scene
    double radius = 0.0;  ///< from the centre to the corner farthest from it
};

/// What stands out of a plane by less than this share of its distance from a point of the plane lies in it.
constexpr double planeTolerance = 1e-12;

/// How far a point stands out of a plane; 0 where rounding alone may have moved it off.
double heightOver(const Point& point, const Point& on, const Point& normal);

/// The smallest and the largest of some numbers.
struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void add(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

/// How far the corners of a polygon stand out of a plane, as computed.
Range heightsOver(const Polygon& polygon, const Point& on, const Point& normal);

/// Whether some of each polygon stands in front of the other's plane, beyond rounding.
bool faceEachOther(const Polygon& a, const Polygon& b);

/// The part of a polygon in front of a plane; a polygon without corners where nothing is.
///
/// @param on      a point of the plane
/// @param normal  unit normal of the plane
/// @source [SutherlandHodgman1974]; where a concave polygon falls apart, its pieces hang together by edges that cancel
Polygon frontPart(const Polygon& polygon, const Point& on, const Point& normal);

/// How far a point is from the outline of a polygon, seen as lines: 0 on an edge, not inside.
double distanceToOutline(const Point& point, const Polygon& polygon);

/// A point of a polygon and the area that it stands for.
struct Node {
    Point position;
    double weight;
};

/// Gauss-Legendre nodes over a polygon: functions that are smooth on its scale are integrated to 2·order digits and more.
///
/// @param order  nodes in each of two directions, 1 to mostGaussNodes
/// @return their weights add up to the area; for a polygon that is not convex some may be negative, or lie beside it
/// @cost order² nodes for four corners, order² for each triangle of a fan else
std::vector<Node> gaussNodes(const Polygon& polygon, int order);

}  // namespace radlab::engine
