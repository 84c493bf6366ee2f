#include "scene/CoincidentFaces.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>

#include "base/Interrupts.h"
#include "course/FacePolygon.h"

namespace radlab {

namespace {

constexpr double leastShare = 1e-3;  // of the smaller face
constexpr double mostBent = 1e-3;    // of a face's size: its corners off its plane, as the Mesher takes them
constexpr std::size_t facesInLeaf = 4;
constexpr std::size_t stepsAtLeast = 20'000'000, stepsPerFace = 200,
                      stepsPerFind = 1000;  // a hundred millionth of a second each, or so

struct Box {
    Vec3f low{INFINITY}, high{-INFINITY};

    void add(const Box& other) {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
};

// Whether faces in two boxes may share an area: it reaches along two axes at least.
bool mayShareArea(const Box& a, const Box& b, float resolution) {
    int along = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const float common = std::min(a.high[axis], b.high[axis]) - std::max(a.low[axis], b.low[axis]);
        if (common < -resolution) return false;
        if (common > 0.0f) ++along;
    }
    return along >= 2;
}

// A face as it lies in space, with its corners as seen along the axis that it faces most.
struct Flat {
    explicit Flat(Corners outline) : corners(std::move(outline)), area(areaVector(corners)) {
        resolution = floatResolution(corners);
    }

    bool isEmpty() const { return hasNoArea(corners, glm::length(area)); }
    int mainAxis() const {
        const glm::dvec3 size = glm::abs(area);
        return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    }
    Polygon2 seenAlong(int axis) const {
        Polygon2 seen;
        for (const glm::dvec3& corner : corners) seen.emplace_back(corner[(axis + 1) % 3], corner[(axis + 2) % 3]);
        return seen;
    }

    Corners corners;
    glm::dvec3 area;
    double resolution;
};

Flat flatOf(const Scene& scene, std::size_t face) {
    Corners corners;
    for (const int corner : scene.faces[face].corners)
        corners.emplace_back(scene.vertices[static_cast<std::size_t>(corner)]);
    return Flat(std::move(corners));
}

// Whether all of a face lies in the plane of another that is no smaller, as far as floats tell places apart.
bool liesInPlane(const Flat& small, const Flat& large) {
    const glm::dvec3 normal = glm::normalize(large.area), on = areaCentroid(large.corners, normal);
    const auto height = [&](const Corners& corners) {
        double most = 0.0;
        for (const glm::dvec3& corner : corners) most = std::max(most, std::abs(glm::dot(corner - on, normal)));
        return most;
    };
    const double bent = std::min(height(large.corners), mostBent * diameter(large.corners));
    return height(small.corners) <= bent + std::max(small.resolution, large.resolution);
}

// What is left of the line from a to b; of a polygon that is not convex, pieces may hang together by edges that cancel.
Polygon2 leftPart(const Polygon2& polygon, const glm::dvec2& a, const glm::dvec2& b) {
    const auto side = [&](const glm::dvec2& p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); };
    Polygon2 part;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
        const double here = side(from), there = side(to);
        if (here >= 0.0) part.push_back(from);
        if ((here > 0.0 && there < 0.0) || (here < 0.0 && there > 0.0))
            part.push_back(from + here / (here - there) * (to - from));
    }
    return part;
}

// A polygon is the sum of a fan of triangles, of which those that turn the other way count less than nothing.
double commonArea(const Polygon2& a, const Polygon2& b) {
    double sum = 0.0;
    for (std::size_t i = 1; i + 1 < b.size(); ++i) {
        Polygon2 triangle{b[0], b[i], b[i + 1]};
        const double sign = signedArea(triangle) < 0.0 ? -1.0 : 1.0;
        if (sign < 0.0) std::swap(triangle[1], triangle[2]);
        Polygon2 common = a;
        for (std::size_t k = 0; k < 3; ++k) common = leftPart(common, triangle[k], triangle[(k + 1) % 3]);
        sum += sign * signedArea(common);
    }
    return std::abs(sum);
}

bool shareFront(const Flat& a, const Flat& b) {
    if (a.isEmpty() || b.isEmpty() || glm::dot(a.area, b.area) <= 0.0) return false;
    const bool aIsSmaller = glm::length(a.area) < glm::length(b.area);
    const Flat &small = aIsSmaller ? a : b, &large = aIsSmaller ? b : a;
    if (!liesInPlane(small, large)) return false;
    const int axis = large.mainAxis();
    const Polygon2 seen = small.seenAlong(axis);
    // Neighbours may overlap by what their corners were rounded.
    const double rounded = std::max(small.resolution, large.resolution) * 2.0 * diameter(small.corners);
    return commonArea(seen, large.seenAlong(axis)) > leastShare * std::abs(signedArea(seen)) + rounded;
}

// A tree of boxes over the faces, halved again and again across the longest side.
class Search {
public:
    explicit Search(const Scene& faces)
        : scene(faces), boxes(faces.faces.size()), order(faces.faces.size()), isUpon(faces.faces.size()) {
        steps = stepsAtLeast + stepsPerFace * order.size();
        std::iota(order.begin(), order.end(), 0u);
        for (std::size_t i = 0; i < order.size(); ++i)
            for (const int corner : scene.faces[i].corners) {
                Interrupts::check();
                const Vec3f& at = scene.vertices[static_cast<std::size_t>(corner)];
                boxes[i].add({at, at});
                for (int axis = 0; axis < 3; ++axis)
                    resolution = std::max(resolution, 4.0f * FLT_EPSILON * std::abs(at[axis]));
            }
        if (!order.empty()) build({0, 0, order.size()});
    }

    CoincidentFaces run() {
        if (!order.empty()) within({0, 0, order.size()});
        found.complete = steps > 0;
        return found;
    }

private:
    struct Node {
        std::size_t index, begin, end;

        std::size_t size() const { return end - begin; }
        Node half(int which) const {
            const std::size_t middle = begin + size() / 2;
            return which == 0 ? Node{2 * index + 1, begin, middle} : Node{2 * index + 2, middle, end};
        }
    };

    void build(const Node& node) {
        Interrupts::check();
        if (boxOf.size() <= node.index) boxOf.resize(node.index + 1);
        Box box;
        for (std::size_t k = node.begin; k < node.end; ++k) box.add(boxes[order[k]]);
        boxOf[node.index] = box;
        if (node.size() <= facesInLeaf) return;
        const Vec3f size = box.high - box.low;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const auto middle = [&](std::uint32_t face) { return boxes[face].low[axis] / 2 + boxes[face].high[axis] / 2; };
        const auto at = [&](std::size_t k) { return order.begin() + static_cast<std::ptrdiff_t>(k); };
        std::nth_element(at(node.begin), at(node.half(1).begin), at(node.end),
                         [&](std::uint32_t a, std::uint32_t b) { return middle(a) < middle(b); });
        for (const int which : {0, 1}) build(node.half(which));
    }

    void within(const Node& node) {
        if (node.size() > facesInLeaf) {
            for (const int which : {0, 1}) within(node.half(which));
            return across(node.half(0), node.half(1));
        }
        for (std::size_t k = node.begin; k < node.end; ++k)
            for (std::size_t l = k + 1; l < node.end; ++l) compare(order[k], order[l]);
    }

    void across(const Node& a, const Node& b) {
        if (!spend(1) || !mayShareArea(boxOf[a.index], boxOf[b.index], resolution)) return;
        const Node &large = a.size() >= b.size() ? a : b, &small = a.size() >= b.size() ? b : a;
        if (large.size() > facesInLeaf) {
            for (const int which : {0, 1}) across(large.half(which), small);
            return;
        }
        for (std::size_t k = a.begin; k < a.end; ++k)
            for (std::size_t l = b.begin; l < b.end; ++l) compare(order[k], order[l]);
    }

    void compare(std::size_t i, std::size_t j) {
        const auto [earlier, later] = std::minmax(i, j);
        if (!mayShareArea(boxes[earlier], boxes[later], resolution)) return;
        if (!spend(4 * scene.faces[earlier].corners.size() * scene.faces[later].corners.size())) return;
        if (!shareFront(flatOf(scene, earlier), flatOf(scene, later))) return;
        if (found.count == 0 || std::tie(later, earlier) < std::tie(found.later, found.earlier)) {
            found.earlier = earlier;
            found.later = later;
        }
        spend(stepsPerFind);
        if (!isUpon[later]) ++found.count;
        isUpon[later] = true;
    }

    bool spend(std::size_t some) {
        Interrupts::check();
        steps = some < steps ? steps - some : 0;
        return steps > 0;
    }

    const Scene& scene;
    std::vector<Box> boxes, boxOf;  // of faces, of nodes
    std::vector<std::uint32_t> order;
    std::vector<bool> isUpon;
    float resolution = 0.0f;
    std::size_t steps = 0;  // left
    CoincidentFaces found;
};

std::string nameOf(const Scene& scene, std::size_t face) {
    return "face " + std::to_string(face) + " (line " + std::to_string(scene.faces[face].where.line) + ")";
}

}  // namespace

CoincidentFaces findCoincidentFaces(const Scene& scene) { return Search(scene).run(); }

std::string describe(const CoincidentFaces& found, const Scene& scene) {
    if (found.count == 0) return "";
    return "faces in the place of an earlier one, facing the same way: " +
           (found.complete ? std::to_string(found.count) + ", the first is "
                           : "at least " + std::to_string(found.count) + ", one is ") +
           nameOf(scene, found.later) + ", upon " + nameOf(scene, found.earlier) +
           ", counted from 0; hemicubes see the earlier one, rays either, and exact form factors light both: expected "
           "one face in a place";
}

}  // namespace radlab
