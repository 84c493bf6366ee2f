#include "course/FacePolygon.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace radlab {

namespace {

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    const glm::dvec2 u = b - a, v = c - b;
    return u.x * v.y - u.y * v.x;
}

double straightTolerance(const Polygon2& polygon) { return 1e-9 * std::abs(signedArea(polygon)); }

bool inside(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, double tolerance) {
    return turn(a, b, p) >= -tolerance && turn(b, c, p) >= -tolerance && turn(c, a, p) >= -tolerance;
}

// Whether a triangle may be cut off at a corner; others that lie on its edges within a tolerance forbid it.
bool isEar(const Polygon2& polygon, std::size_t i, double tolerance) {
    const std::size_t count = polygon.size();
    const glm::dvec2 &a = polygon[(i + count - 1) % count], &b = polygon[i], &c = polygon[(i + 1) % count];
    if (turn(a, b, c) <= 0.0) return false;
    return std::none_of(polygon.begin(), polygon.end(), [&](const glm::dvec2& p) {
        return p != a && p != b && p != c && inside(p, a, b, c, tolerance);
    });
}

// An ear that is one beyond rounding, else one within it, else any: only straight or touching corners are left.
std::size_t findEar(const Polygon2& polygon, double tolerance) {
    for (const double slack : {tolerance, 0.0})
        for (std::size_t i = 0; i < polygon.size(); ++i)
            if (isEar(polygon, i, slack)) return i;
    return 0;
}

std::vector<Polygon2> earTriangles(Polygon2 rest) {
    const double tolerance = straightTolerance(rest);
    std::vector<Polygon2> triangles;
    while (rest.size() > 3) {
        const std::size_t ear = findEar(rest, tolerance);
        const std::size_t count = rest.size();
        triangles.push_back({rest[(ear + count - 1) % count], rest[ear], rest[(ear + 1) % count]});
        rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    triangles.push_back(rest);
    return triangles;
}

// a and b share the edge a[i] a[i+1] = b[j+1] b[j]: their union, starting after that edge.
Polygon2 joined(const Polygon2& a, std::size_t i, const Polygon2& b, std::size_t j) {
    Polygon2 whole;
    for (std::size_t k = 1; k < a.size(); ++k) whole.push_back(a[(i + k) % a.size()]);
    for (std::size_t k = 1; k < b.size(); ++k) whole.push_back(b[(j + k) % b.size()]);
    return whole;
}

bool mergeIfConvex(Polygon2& a, const Polygon2& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        for (std::size_t j = 0; j < b.size(); ++j) {
            if (a[i] != b[(j + 1) % b.size()] || a[(i + 1) % a.size()] != b[j]) continue;
            Polygon2 whole = joined(a, i, b, j);
            if (!isConvex(whole)) return false;
            a = std::move(whole);
            return true;
        }
    }
    return false;
}

void dropStraightCorners(Polygon2& polygon) {
    const double tolerance = straightTolerance(polygon);
    for (std::size_t i = 0; i < polygon.size() && polygon.size() > 3;) {
        const std::size_t count = polygon.size();
        if (std::abs(turn(polygon[(i + count - 1) % count], polygon[i], polygon[(i + 1) % count])) <= tolerance)
            polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(i));
        else
            ++i;
    }
}

}  // namespace

double diameter(const Corners& corners) {
    double largest = 0.0;
    for (const glm::dvec3& a : corners)
        for (const glm::dvec3& b : corners) largest = std::max(largest, glm::distance(a, b));
    return largest;
}

double floatResolution(const Corners& corners) {
    double farthest = 0.0;
    for (const glm::dvec3& corner : corners)
        for (int axis = 0; axis < 3; ++axis) farthest = std::max(farthest, std::abs(corner[axis]));
    return 2.0 * FLT_EPSILON * farthest;
}

bool hasNoArea(const Corners& corners, double area) { return area <= floatResolution(corners) * diameter(corners); }

double distanceToSegment(const glm::dvec3& point, const glm::dvec3& begin, const glm::dvec3& end) {
    const glm::dvec3 edge = end - begin;
    const double length2 = glm::dot(edge, edge);
    const double t = length2 > 0.0 ? std::clamp(glm::dot(point - begin, edge) / length2, 0.0, 1.0) : 0.0;
    return glm::distance(point, begin + t * edge);
}

glm::dvec3 axisAcross(const glm::dvec3& direction) {
    return std::abs(direction.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
}

glm::dvec3 areaVector(const Corners& corners) {
    glm::dvec3 sum(0.0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    return 0.5 * sum;
}

glm::dvec3 areaCentroid(const Corners& corners, const glm::dvec3& normal) {
    glm::dvec3 moment(0.0);
    double area = 0.0;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const glm::dvec3 u = corners[i] - corners[0], v = corners[i + 1] - corners[0];
        const double part = glm::dot(glm::cross(u, v), normal);
        area += part;
        moment += part * (u + v) / 3.0;
    }
    return corners[0] + moment / area;
}

double signedArea(const Polygon2& polygon) {
    double twice = 0.0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        const glm::dvec2 u = polygon[i] - polygon[0], v = polygon[i + 1] - polygon[0];
        twice += u.x * v.y - u.y * v.x;
    }
    return 0.5 * twice;
}

bool isConvex(const Polygon2& polygon) {
    const double tolerance = straightTolerance(polygon);
    const std::size_t count = polygon.size();
    for (std::size_t i = 0; i < count; ++i)
        if (turn(polygon[i], polygon[(i + 1) % count], polygon[(i + 2) % count]) < -tolerance) return false;
    // A star that winds round twice turns left everywhere, too.
    for (std::size_t i = 1; i + 1 < count; ++i)
        if (signedArea({polygon[0], polygon[i], polygon[i + 1]}) < -tolerance) return false;
    return true;
}

std::vector<Polygon2> convexPieces(const Polygon2& polygon) {
    if (isConvex(polygon)) return {polygon};
    return mergedWhereConvex(earTriangles(polygon));
}

std::vector<Polygon2> mergedWhereConvex(const std::vector<Polygon2>& polygons) {
    std::vector<Polygon2> pieces;
    for (const Polygon2& polygon : polygons) {
        const bool merged =
            std::any_of(pieces.begin(), pieces.end(), [&](Polygon2& piece) { return mergeIfConvex(piece, polygon); });
        if (!merged) pieces.push_back(polygon);
    }
    for (Polygon2& piece : pieces) dropStraightCorners(piece);
    return pieces;
}

Polygon2 clipAtLine(const Polygon2& polygon, int axis, double limit, bool keepBelow) {
    const double sign = keepBelow ? 1.0 : -1.0;
    Polygon2 kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
        const double fromOver = sign * (from[axis] - limit), toOver = sign * (to[axis] - limit);
        if (fromOver <= 0.0) kept.push_back(from);
        if ((fromOver < 0.0 && toOver > 0.0) || (fromOver > 0.0 && toOver < 0.0)) {
            glm::dvec2 cut = glm::mix(from, to, fromOver / (fromOver - toOver));
            cut[axis] = limit;
            kept.push_back(cut);
        }
    }
    return kept;
}

}  // namespace radlab
