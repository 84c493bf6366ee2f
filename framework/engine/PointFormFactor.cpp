#include "engine/PointFormFactor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace radlab::engine {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double farRadii = 100.0;
constexpr int farOrder = 4;

}  // namespace

double pointToPoint(const Polygon& from, const Polygon& to) {
    const Point between = to.center - from.center;
    const double distance2 = glm::dot(between, between);
    if (distance2 == 0.0) return 0.0;
    const double away = std::max(glm::dot(from.normal, between), 0.0),
                 towards = std::max(-glm::dot(to.normal, between), 0.0);
    return away * towards / (distance2 * distance2) * to.area / pi;
}

double lambertSum(const Point& point, const Point& normal, const Polygon& polygon) {
    double sum = 0.0;
    Point a = polygon.corners.back() - point;
    for (const Point& corner : polygon.corners) {
        const Point b = corner - point, cross = glm::cross(a, b);
        const double sine = glm::length(cross);
        if (sine > 0.0) sum -= std::atan2(sine, glm::dot(a, b)) * glm::dot(normal, cross) / sine;
        a = b;
    }
    return sum / (2.0 * pi);
}

double pointToPolygon(const Point& point, const Point& normal, const Polygon& polygon) {
    if (heightOver(point, polygon.center, polygon.normal) <= 0.0) return 0.0;
    const Polygon seen = frontPart(polygon, point, normal);
    if (seen.corners.empty()) return 0.0;
    if (glm::length(seen.center - point) < farRadii * seen.radius)
        return std::clamp(lambertSum(point, normal, seen), 0.0, 1.0);
    double sum = 0.0;
    for (const Node& node : gaussNodes(seen, farOrder)) {
        const Point between = node.position - point;
        const double distance2 = glm::dot(between, between);
        sum -= node.weight * glm::dot(normal, between) * glm::dot(polygon.normal, between) / (distance2 * distance2);
    }
    return std::max(sum / pi, 0.0);
}

}  // namespace radlab::engine
