#include "engine/ExchangeArea.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <tbb/parallel_for.h>

#include "base/Error.h"
#include "base/Interrupts.h"
#include "base/Memory.h"
#include "engine/EdgeIntegral.h"
#include "engine/PointFormFactor.h"

namespace radlab::engine {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int mostFarOrder = 6;     // above that, the outlines are cheaper
constexpr double muchLarger = 8.0;  // radii: above that, a polygon is cut before its outline is followed
constexpr std::size_t lanes = 4;

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

// Adds what one node sees of all nodes of a polygon; the sums run side by side, so that they can share instructions.
inline void addRow(double sums[lanes], double weight, const Point& from, const Point& normal,
                   const NodeTable::Nodes& to, const Point& toNormal) {
    for (std::size_t k = 0; k < to.padded; k += lanes)
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const double x = to.x[k + lane] - from.x, y = to.y[k + lane] - from.y, z = to.z[k + lane] - from.z;
            const double distance2 = x * x + y * y + z * z;
            const double away = x * normal.x + y * normal.y + z * normal.z;
            const double towards = x * toNormal.x + y * toNormal.y + z * toNormal.z;
            sums[lane] -= weight * to.weight[k + lane] * away * towards / (distance2 * distance2);
        }
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
    double sums[lanes] = {};
    for (std::size_t k = 0; k < a.count; ++k)
        addRow(sums, a.weight[k], Point(a.x[k], a.y[k], a.z[k]), normalA, b, normalB);
    return ((sums[0] + sums[1]) + (sums[2] + sums[3])) * std::numbers::inv_pi;
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

double between(const Polygon& a, const Polygon& b, const GaussOrders& orders);

// The larger polygon in four pieces, by two planes through its centre.
double cutLarger(const Polygon& small, const Polygon& large, const GaussOrders& orders) {
    const Point along = glm::normalize(large.corners[1] - large.corners[0]), across = glm::cross(large.normal, along);
    double sum = 0.0;
    for (const Point& first : {along, -along}) {
        const Polygon half = frontPart(large, large.center, first);
        if (half.corners.empty()) continue;
        for (const Point& second : {across, -across}) {
            const Polygon quarter = frontPart(half, large.center, second);
            if (quarter.area > 0.0) sum += between(small, quarter, orders);
        }
    }
    return sum;
}

struct Orders {
    int a, b;
    int highest() const { return std::max(a, b); }
};

Orders ordersFor(const Polygon& a, const Polygon& b, double distance, const GaussOrders& orders) {
    return {orders.at((distance - b.radius) / a.radius), orders.at((distance - a.radius) / b.radius)};
}

// Two polygons that are too near for nodes on both.
double near(const Polygon& a, const Polygon& b, const GaussOrders& orders) {
    if (a.radius > b.radius) return near(b, a, orders);
    const int order = orders.at(distanceToOutline(a.center, b) / a.radius);
    if (order <= GaussOrders::most) return fromNodes(a, order, b);
    return b.radius > muchLarger * a.radius ? cutLarger(a, b, orders) : alongOutlines(a, b, 0.1 * orders.tolerance());
}

double far(const Polygon& a, const Polygon& b, const Orders& orders) {
    thread_local std::vector<double> ofA, ofB;
    return byNodes(nodesOf(a, orders.a, ofA), a.normal, nodesOf(b, orders.b, ofB), b.normal);
}

double between(const Polygon& a, const Polygon& b, const GaussOrders& orders) {
    const Orders both = ordersFor(a, b, glm::length(b.center - a.center), orders);
    return both.highest() <= mostFarOrder ? far(a, b, both) : near(a, b, orders);
}

enum class Side { front, back, across };

// On which side of its plane a polygon has another one; what touches the plane up to rounding is not across it.
Side sideOf(const Polygon& plane, const Polygon& polygon, const Point& between, double distance) {
    const double rounding = planeTolerance * (distance + polygon.radius);
    const double height = glm::dot(between, plane.normal);
    if (std::abs(height) > polygon.radius + rounding) return height > 0.0 ? Side::front : Side::back;
    const Range heights = heightsOver(polygon, plane.center, plane.normal);
    if (heights.high <= rounding) return Side::back;
    return heights.low >= -rounding ? Side::front : Side::across;
}

const GaussOrders& ordersWithin(double tolerance) {
    thread_local GaussOrders last(tolerance);
    if (last.tolerance() != tolerance) last = GaussOrders(tolerance);
    return last;
}

}  // namespace

double exchangeArea(const Polygon& a, const Polygon& b, double tolerance) {
    RADLAB_CHECK(tolerance >= finestTolerance);
    const Polygon inFrontA = frontPart(a, b.center, b.normal), inFrontB = frontPart(b, a.center, a.normal);
    if (!(inFrontA.area > 0.0) || !(inFrontB.area > 0.0)) return 0.0;
    return std::max(between(inFrontA, inFrontB, ordersWithin(tolerance)), 0.0);
}

NodeTable::NodeTable(const std::vector<Polygon>& list, int order) : first(list.size() + 1) {
    for (std::size_t i = 0; i < list.size(); ++i) {
        counts.push_back(countOf(list[i], order));
        first[i + 1] = first[i] + 4 * paddedTo(lanes, counts[i]);
    }
    numbers.resize(first.back());
    tbb::parallel_for(std::size_t{0}, list.size(), [&](std::size_t i) {
        Interrupts::check();
        if (counts[i] > 0) fill(gaussNodes(list[i], order), numbers.data() + first[i]);
    });
}

NodeTable::Nodes NodeTable::of(std::size_t polygon) const {
    return nodesAt(numbers.data() + first[polygon], counts[polygon]);
}

ExchangeAreas::ExchangeAreas(const std::vector<Polygon>& list, double tolerance) : polygons(list), orders(tolerance) {
    RADLAB_CHECK(tolerance >= finestTolerance);
    requireMemory(1024.0 * static_cast<double>(list.size()),
                  "the nodes of " + std::to_string(list.size()) + " polygons", "take larger patches");
    for (int order = 1; order <= keptOrders; ++order) nodes[order - 1] = NodeTable(polygons, order);
}

double ExchangeAreas::operator()(std::size_t i, std::size_t j) const {
    const Polygon &a = polygons[i], &b = polygons[j];
    if (!(a.area > 0.0) || !(b.area > 0.0)) return 0.0;
    const Point between = b.center - a.center;
    const double distance = glm::length(between);
    const Side ofA = sideOf(a, b, between, distance), ofB = sideOf(b, a, -between, distance);
    if (ofA == Side::back || ofB == Side::back) return 0.0;
    if (ofA == Side::across || ofB == Side::across) return exchangeArea(a, b, orders.tolerance());
    const Orders both = ordersFor(a, b, distance, orders);
    if (both.highest() > mostFarOrder) return std::max(near(a, b, orders), 0.0);
    if (both.highest() > keptOrders) return std::max(far(a, b, both), 0.0);
    return std::max(byNodes(nodes[both.a - 1].of(i), a.normal, nodes[both.b - 1].of(j), b.normal), 0.0);
}

}  // namespace radlab::engine
