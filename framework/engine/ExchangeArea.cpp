#include "engine/ExchangeArea.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <tbb/parallel_for.h>

#include "base/Error.h"
#include "engine/EdgeIntegral.h"
#include "engine/GaussLegendre.h"
#include "engine/PointFormFactor.h"

namespace radlab::engine {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int mostFarOrder = 6;  // above that, the outlines are cheaper
constexpr int mostNearOrder = 12;
constexpr double muchLarger = 8.0;  // radii: above that, a polygon is cut before its outline is followed
constexpr std::size_t lanes = 4;

// How many nodes Gauss-Legendre needs in each direction for a function whose nearest singularity is that many half
// lengths off the middle: its error falls as ρ^(-2 order), with ρ the size of the ellipse through the singularity. Measured on
// squares in random places, the largest error is at most 8 times the distance times that.
double orderFor(double distance, double tolerance) {
    if (distance <= 1.0) return INFINITY;
    const double ellipse = distance + std::sqrt(distance * distance - 1.0);
    return std::ceil(0.5 * std::log(8.0 * distance / tolerance) / std::log(ellipse));
}

std::size_t paddedTo(std::size_t multiple, std::size_t count) { return (count + multiple - 1) / multiple * multiple; }

std::size_t countOf(const Polygon& polygon, int order) {
    const std::size_t pieces = polygon.corners.size() == 4 ? 1 : polygon.corners.size() - 2;
    return polygon.area > 0.0 ? static_cast<std::size_t>(order * order) * pieces : 0;
}

NodeTable::Nodes nodesAt(const double* x, std::size_t count) {
    const std::size_t padded = paddedTo(lanes, count);
    return {x, x + padded, x + 2 * padded, x + 3 * padded, count, padded};
}

void fill(const std::vector<Node>& nodes, double* numbers) {
    const std::size_t padded = paddedTo(lanes, nodes.size());
    for (std::size_t k = 0; k < padded; ++k) {
        const Node& node = nodes[std::min(k, nodes.size() - 1)];
        for (std::size_t axis = 0; axis < 3; ++axis) numbers[axis * padded + k] = node.position[static_cast<int>(axis)];
        numbers[3 * padded + k] = k < nodes.size() ? node.weight : 0.0;
    }
}

NodeTable::Nodes nodesOf(const Polygon& polygon, int order, std::vector<double>& numbers) {
    const std::vector<Node> nodes = gaussNodes(polygon, order);
    numbers.resize(4 * paddedTo(lanes, nodes.size()));
    fill(nodes, numbers.data());
    return nodesAt(numbers.data(), nodes.size());
}

// What one node sees of all nodes of a polygon; the sums run side by side, so that they can share instructions.
double rowSum(const Point& from, const Point& normal, const NodeTable::Nodes& to, const Point& toNormal) {
    double sums[lanes] = {};
    for (std::size_t k = 0; k < to.padded; k += lanes)
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const double x = to.x[k + lane] - from.x, y = to.y[k + lane] - from.y, z = to.z[k + lane] - from.z;
            const double distance2 = x * x + y * y + z * z;
            const double away = x * normal.x + y * normal.y + z * normal.z;
            const double towards = x * toNormal.x + y * toNormal.y + z * toNormal.z;
            sums[lane] -= to.weight[k + lane] * away * towards / (distance2 * distance2);
        }
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

// Compiled for AVX2, too, where the compiler can choose when the program starts; not with fused multiplications, so that
// the bits are the same on every machine.
#if defined(__x86_64__) && defined(__linux__) && defined(__GNUC__) && !defined(__clang__)
#define RADLAB_WIDE __attribute__((target_clones("avx2", "default")))
#else
#define RADLAB_WIDE
#endif

RADLAB_WIDE double byNodes(const NodeTable::Nodes& a, const Point& normalA, const NodeTable::Nodes& b,
                           const Point& normalB) {
    double sum = 0.0;
    for (std::size_t k = 0; k < a.count; ++k)
        sum += a.weight[k] * rowSum(Point(a.x[k], a.y[k], a.z[k]), normalA, b, normalB);
    return sum / pi;
}

double fromNodes(const Polygon& small, int order, const Polygon& large) {
    double sum = 0.0;
    for (const Node& node : gaussNodes(small, order))
        sum += node.weight * lambertSum(node.position, small.normal, large);
    return sum;
}

// The corners in a frame in which lengths are about 1 and the origin is near: logarithms are small there, and cancel
// less.
std::vector<Edge> edgesOf(const Polygon& polygon, const Point& origin, double unit) {
    std::vector<Edge> edges;
    const std::size_t count = polygon.corners.size();
    for (std::size_t i = 0; i < count; ++i)
        edges.push_back({(polygon.corners[i] - origin) / unit, (polygon.corners[(i + 1) % count] - origin) / unit});
    return edges;
}

double alongOutlines(const Polygon& a, const Polygon& b, double tolerance) {
    const double unit = glm::length(b.center - a.center) + 0.5 * (a.radius + b.radius);
    const std::vector<Edge> edgesA = edgesOf(a, a.center, unit), edgesB = edgesOf(b, a.center, unit);
    double sum = 0.0;
    for (const Edge& edgeA : edgesA)
        for (const Edge& edgeB : edgesB) {
            const Point directionA = edgeA.end - edgeA.begin, directionB = edgeB.end - edgeB.begin;
            const double lengths = glm::length(directionA) * glm::length(directionB);
            const double along = glm::dot(directionA, directionB);
            if (std::abs(along) > 1e-17 * lengths) sum += along / lengths * edgeIntegral(edgeA, edgeB, tolerance);
        }
    return sum / (2.0 * pi) * unit * unit;
}

double between(const Polygon& a, const Polygon& b, double tolerance);

// The larger polygon in four pieces, by two planes through its centre.
double cutLarger(const Polygon& small, const Polygon& large, double tolerance) {
    const Point along = glm::normalize(large.corners[1] - large.corners[0]), across = glm::cross(large.normal, along);
    double sum = 0.0;
    for (const Point& first : {along, -along}) {
        const Polygon half = frontPart(large, large.center, first);
        if (half.corners.empty()) continue;
        for (const Point& second : {across, -across}) {
            const Polygon quarter = frontPart(half, large.center, second);
            if (quarter.area > 0.0) sum += between(small, quarter, tolerance);
        }
    }
    return sum;
}

struct Orders {
    double a, b;
    bool far() const { return std::max(a, b) <= mostFarOrder; }
};

Orders ordersFor(const Polygon& a, const Polygon& b, double distance, double tolerance) {
    return {orderFor((distance - b.radius) / a.radius, tolerance),
            orderFor((distance - a.radius) / b.radius, tolerance)};
}

// Two polygons that are too near for nodes on both.
double near(const Polygon& a, const Polygon& b, double tolerance) {
    if (a.radius > b.radius) return near(b, a, tolerance);
    const double order = orderFor(distanceToOutline(a.center, b) / a.radius, tolerance);
    if (order <= mostNearOrder) return fromNodes(a, static_cast<int>(order), b);
    return b.radius > muchLarger * a.radius ? cutLarger(a, b, tolerance) : alongOutlines(a, b, 0.1 * tolerance);
}

double far(const Polygon& a, const Polygon& b, const Orders& orders) {
    thread_local std::vector<double> ofA, ofB;
    return byNodes(nodesOf(a, static_cast<int>(orders.a), ofA), a.normal, nodesOf(b, static_cast<int>(orders.b), ofB),
                   b.normal);
}

double between(const Polygon& a, const Polygon& b, double tolerance) {
    const Orders orders = ordersFor(a, b, glm::length(b.center - a.center), tolerance);
    return orders.far() ? far(a, b, orders) : near(a, b, tolerance);
}

enum class Side { front, back, across };

// On which side of its plane a polygon has another one; what touches the plane up to rounding is not across it.
Side sideOf(const Polygon& plane, const Polygon& polygon, double distance) {
    const Range heights = heightsOver(polygon, plane.center, plane.normal);
    const double rounding = planeTolerance * (distance + polygon.radius);
    if (heights.high <= rounding) return Side::back;
    return heights.low >= -rounding ? Side::front : Side::across;
}

}  // namespace

double exchangeArea(const Polygon& a, const Polygon& b, double tolerance) {
    RADLAB_CHECK(tolerance >= finestTolerance);
    const Polygon inFrontA = frontPart(a, b.center, b.normal), inFrontB = frontPart(b, a.center, a.normal);
    if (!(inFrontA.area > 0.0) || !(inFrontB.area > 0.0)) return 0.0;
    return std::max(between(inFrontA, inFrontB, tolerance), 0.0);
}

NodeTable::NodeTable(const std::vector<Polygon>& polygons, int order) : first(polygons.size() + 1) {
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        counts.push_back(countOf(polygons[i], order));
        first[i + 1] = first[i] + 4 * paddedTo(lanes, counts[i]);
    }
    numbers.resize(first.back());
    tbb::parallel_for(std::size_t{0}, polygons.size(), [&](std::size_t i) {
        if (counts[i] > 0) fill(gaussNodes(polygons[i], order), numbers.data() + first[i]);
    });
}

NodeTable::Nodes NodeTable::of(std::size_t polygon) const {
    return nodesAt(numbers.data() + first[polygon], counts[polygon]);
}

ExchangeAreas::ExchangeAreas(const std::vector<Polygon>& list, double error) : polygons(list), tolerance(error) {
    RADLAB_CHECK(tolerance >= finestTolerance);
    for (int order = 1; order <= keptOrders; ++order) nodes[order - 1] = NodeTable(polygons, order);
}

double ExchangeAreas::operator()(std::size_t i, std::size_t j) const {
    const Polygon &a = polygons[i], &b = polygons[j];
    if (!(a.area > 0.0) || !(b.area > 0.0)) return 0.0;
    const double distance = glm::length(b.center - a.center);
    const Side ofA = sideOf(a, b, distance), ofB = sideOf(b, a, distance);
    if (ofA == Side::back || ofB == Side::back) return 0.0;
    if (ofA == Side::across || ofB == Side::across) return exchangeArea(a, b, tolerance);
    const Orders orders = ordersFor(a, b, distance, tolerance);
    if (!orders.far()) return std::max(near(a, b, tolerance), 0.0);
    const auto orderA = static_cast<std::size_t>(orders.a), orderB = static_cast<std::size_t>(orders.b);
    if (std::max(orderA, orderB) > keptOrders) return std::max(far(a, b, orders), 0.0);
    return std::max(byNodes(nodes[orderA - 1].of(i), a.normal, nodes[orderB - 1].of(j), b.normal), 0.0);
}

}  // namespace radlab::engine
