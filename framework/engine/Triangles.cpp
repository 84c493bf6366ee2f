#include "engine/Triangles.h"

#include <algorithm>
#include <cmath>

#include "course/FacePolygon.h"

namespace radlab::engine {

namespace {

double areaOf(const Triangle& t) { return 0.5 * glm::length(glm::cross(t[1] - t[0], t[2] - t[0])); }

// Up to the rounding of floats.
bool isParallelogram(const Polygon& polygon) {
    const std::vector<Point>& c = polygon.corners;
    return c.size() == 4 && polygon.area > 0.0 && glm::length(c[0] - c[1] + c[2] - c[3]) <= 1e-6 * polygon.radius;
}

void addFan(std::vector<Triangle>& triangles, const std::vector<Point>& corners) {
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        const Triangle triangle = {corners[0], corners[i], corners[i + 1]};
        if (areaOf(triangle) > 0.0) triangles.push_back(triangle);
    }
}

}  // namespace

std::vector<Polygon> convexPiecesOf(const Polygon& polygon) {
    if (!(polygon.area > 0.0)) return {};
    const Point& origin = polygon.center;
    const Point x = glm::normalize(glm::cross(axisAcross(polygon.normal), polygon.normal)),
                y = glm::cross(polygon.normal, x);
    Polygon2 flat;
    for (const Point& corner : polygon.corners)
        flat.emplace_back(glm::dot(corner - origin, x), glm::dot(corner - origin, y));
    if (isConvex(flat)) return {polygon};
    std::vector<Polygon> pieces;
    for (const Polygon2& piece : convexPieces(flat)) {
        std::vector<Point> corners;
        for (const glm::dvec2& corner : piece) corners.push_back(origin + corner.x * x + corner.y * y);
        pieces.emplace_back(std::move(corners));
    }
    return pieces;
}

std::vector<Triangle> trianglesOf(const Polygon& polygon) {
    std::vector<Triangle> triangles;
    for (const Polygon& piece : convexPiecesOf(polygon)) addFan(triangles, piece.corners);
    return triangles;
}

Shares::Drawn Shares::draw(double u) const {
    const double at = u * sum;
    const auto found = std::upper_bound(upTo.begin(), upTo.end() - 1, at);
    const double before = found == upTo.begin() ? 0.0 : *(found - 1);
    return {static_cast<std::size_t>(found - upTo.begin()), std::clamp((at - before) / (*found - before), 0.0, 1.0)};
}

AreaSampler::AreaSampler(const Polygon& polygon) : origin(polygon.center) {
    if (isParallelogram(polygon)) {
        origin = polygon.corners[0];
        along = polygon.corners[1] - origin;
        across = polygon.corners[3] - origin;
        return;
    }
    triangles = trianglesOf(polygon);
    for (const Triangle& triangle : triangles) shares.add(areaOf(triangle));
}

Point AreaSampler::at(double u, double v) const {
    if (triangles.empty()) return origin + u * along + v * across;
    const Shares::Drawn drawn = shares.draw(u);
    const Triangle& t = triangles[drawn.which];
    const double root = std::sqrt(drawn.rest);
    return (1.0 - root) * t[0] + root * ((1.0 - v) * t[1] + v * t[2]);
}

}  // namespace radlab::engine
