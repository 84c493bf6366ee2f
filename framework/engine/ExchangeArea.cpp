#include "engine/ExchangeArea.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/EdgeIntegral.h"
#include "engine/GaussLegendre.h"
#include "engine/PointFormFactor.h"

namespace radlab::engine {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double digits = 30.0;  // ln of what the error is to be smaller by: e^-30 is 1e-13
constexpr int mostFarOrder = 6;  // above that, the outlines are cheaper
constexpr int mostNearOrder = 12;
constexpr double muchLarger = 8.0;  // radii: above that, a polygon is cut before its outline is followed

// How many Gauss-Legendre nodes integrate a function whose nearest singularity is that many half lengths off the middle.
double orderFor(double distance) {
    if (distance <= 1.0) return 1e9;
    return 1.5 + 0.5 * digits / std::log(distance + std::sqrt(distance * distance - 1.0));
}

double byNodes(const Polygon& a, int orderA, const Polygon& b, int orderB) {
    const std::vector<Node> nodes = gaussNodes(b, orderB);
    double sum = 0.0;
    for (const Node& from : gaussNodes(a, orderA)) {
        double row = 0.0;
        for (const Node& to : nodes) {
            const Point between = to.position - from.position;
            const double distance2 = glm::dot(between, between);
            row -= to.weight * glm::dot(a.normal, between) * glm::dot(b.normal, between) / (distance2 * distance2);
        }
        sum += from.weight * row;
    }
    return sum / pi;
}

double fromNodes(const Polygon& small, int order, const Polygon& large) {
    double sum = 0.0;
    for (const Node& node : gaussNodes(small, order))
        sum += node.weight * lambertSum(node.position, small.normal, large);
    return sum;
}

// The corners in a frame in which lengths are about 1 and the origin is near: logarithms are small there, and cancel less.
std::vector<Edge> edgesOf(const Polygon& polygon, const Point& origin, double unit) {
    std::vector<Edge> edges;
    const std::size_t count = polygon.corners.size();
    for (std::size_t i = 0; i < count; ++i)
        edges.push_back({(polygon.corners[i] - origin) / unit, (polygon.corners[(i + 1) % count] - origin) / unit});
    return edges;
}

double alongOutlines(const Polygon& a, const Polygon& b) {
    const double unit = glm::length(b.center - a.center) + 0.5 * (a.radius + b.radius);
    const std::vector<Edge> edgesA = edgesOf(a, a.center, unit), edgesB = edgesOf(b, a.center, unit);
    double sum = 0.0;
    for (const Edge& edgeA : edgesA)
        for (const Edge& edgeB : edgesB) {
            const Point directionA = edgeA.end - edgeA.begin, directionB = edgeB.end - edgeB.begin;
            const double lengths = glm::length(directionA) * glm::length(directionB);
            const double along = glm::dot(directionA, directionB);
            if (std::abs(along) > 1e-17 * lengths) sum += along / lengths * edgeIntegral(edgeA, edgeB);
        }
    return sum / (2.0 * pi) * unit * unit;
}

double between(const Polygon& a, const Polygon& b);

// The larger polygon in four pieces, by two planes through its centre.
double cutLarger(const Polygon& small, const Polygon& large) {
    const Point along = glm::normalize(large.corners[1] - large.corners[0]), across = glm::cross(large.normal, along);
    double sum = 0.0;
    for (const Point& first : {along, -along}) {
        const Polygon half = frontPart(large, large.center, first);
        if (half.corners.empty()) continue;
        for (const Point& second : {across, -across}) {
            const Polygon quarter = frontPart(half, large.center, second);
            if (quarter.area > 0.0) sum += between(small, quarter);
        }
    }
    return sum;
}

double between(const Polygon& a, const Polygon& b) {
    if (a.radius > b.radius) return between(b, a);
    const double distance = glm::length(b.center - a.center);
    const double orderA = orderFor((distance - b.radius) / a.radius),
                 orderB = orderFor((distance - a.radius) / b.radius);
    if (std::max(orderA, orderB) < mostFarOrder + 1)
        return byNodes(a, static_cast<int>(orderA), b, static_cast<int>(orderB));
    const double orderNear = orderFor(distanceToOutline(a.center, b) / a.radius);
    if (orderNear < mostNearOrder + 1) return fromNodes(a, static_cast<int>(orderNear), b);
    return b.radius > muchLarger * a.radius ? cutLarger(a, b) : alongOutlines(a, b);
}

}  // namespace

double exchangeArea(const Polygon& a, const Polygon& b) {
    const Polygon inFrontA = frontPart(a, b.center, b.normal), inFrontB = frontPart(b, a.center, a.normal);
    if (!(inFrontA.area > 0.0) || !(inFrontB.area > 0.0)) return 0.0;
    return std::max(between(inFrontA, inFrontB), 0.0);
}

}  // namespace radlab::engine
