#include "engine/Polygon.h"

#include <algorithm>
#include <limits>

#include "course/FacePolygon.h"
#include "engine/GaussLegendre.h"

namespace radlab::engine {

namespace {

void addQuad(std::vector<Node>& nodes, const std::vector<Point>& c, const Point& normal, int order) {
    for (const GaussNode& u : gaussLegendre(order)) {
        const Point low = glm::mix(c[0], c[1], u.position), high = glm::mix(c[3], c[2], u.position);
        const Point rise = high - low;
        for (const GaussNode& v : gaussLegendre(order)) {
            const Point along = glm::mix(c[1] - c[0], c[2] - c[3], v.position);
            nodes.push_back({low + v.position * rise, u.weight * v.weight * glm::dot(glm::cross(along, rise), normal)});
        }
    }
}

void addTriangle(std::vector<Node>& nodes, const Point& tip, const Point& b, const Point& c, const Point& normal,
                 int order) {
    const double twice = glm::dot(glm::cross(b - tip, c - tip), normal);
    for (const GaussNode& u : gaussLegendre(order))
        for (const GaussNode& v : gaussLegendre(order))
            nodes.push_back(
                {glm::mix(tip, glm::mix(b, c, v.position), u.position), u.weight * v.weight * u.position * twice});
}

}  // namespace

Polygon::Polygon(std::vector<Point> outline) : corners(std::move(outline)) {
    if (corners.empty()) return;
    const Point vector = areaVector(corners);
    area = glm::length(vector);
    if (area > 0.0) {
        normal = vector / area;
        center = areaCentroid(corners, normal);
    } else {
        for (const Point& corner : corners) center += corner / static_cast<double>(corners.size());
    }
    for (const Point& corner : corners) radius = std::max(radius, glm::length(corner - center));
}

double heightOver(const Point& point, const Point& on, const Point& normal) {
    const Point from = point - on;
    const double above = glm::dot(from, normal);
    return std::abs(above) <= planeTolerance * glm::length(from) ? 0.0 : above;
}

Range heightsOver(const Polygon& polygon, const Point& on, const Point& normal) {
    Range range;
    for (const Point& corner : polygon.corners) range.add(glm::dot(corner - on, normal));
    return range;
}

bool faceEachOther(const Polygon& a, const Polygon& b) {
    return heightsOver(b, a.center, a.normal).high > planeTolerance * b.radius &&
           heightsOver(a, b.center, b.normal).high > planeTolerance * a.radius;
}

Polygon frontPart(const Polygon& polygon, const Point& on, const Point& normal) {
    const std::size_t count = polygon.corners.size();
    std::vector<double> heights;
    for (const Point& corner : polygon.corners) heights.push_back(heightOver(corner, on, normal));
    if (std::all_of(heights.begin(), heights.end(), [](double h) { return h <= 0.0; })) return {};
    if (std::all_of(heights.begin(), heights.end(), [](double h) { return h >= 0.0; })) return polygon;
    std::vector<Point> front;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t j = (i + 1) % count;
        if (heights[i] >= 0.0) front.push_back(polygon.corners[i]);
        if ((heights[i] < 0.0) != (heights[j] < 0.0) && heights[i] != 0.0 && heights[j] != 0.0)
            front.push_back(glm::mix(polygon.corners[i], polygon.corners[j], heights[i] / (heights[i] - heights[j])));
    }
    Polygon part(std::move(front));
    part.normal = polygon.normal;  // a sliver's own would be worse
    return part;
}

double distanceToOutline(const Point& point, const Polygon& polygon) {
    double nearest = std::numeric_limits<double>::infinity();
    const std::size_t count = polygon.corners.size();
    for (std::size_t i = 0; i < count; ++i)
        nearest = std::min(nearest, distanceToSegment(point, polygon.corners[i], polygon.corners[(i + 1) % count]));
    return nearest;
}

std::vector<Node> gaussNodes(const Polygon& polygon, int order) {
    std::vector<Node> nodes;
    nodes.reserve(static_cast<std::size_t>(order * order) * (polygon.corners.size() == 4 ? 1 : polygon.corners.size()));
    const std::vector<Point>& c = polygon.corners;
    if (c.size() == 4) {
        addQuad(nodes, c, polygon.normal, order);
        return nodes;
    }
    for (std::size_t i = 1; i + 1 < c.size(); ++i) addTriangle(nodes, c[0], c[i], c[i + 1], polygon.normal, order);
    return nodes;
}

}  // namespace radlab::engine
