#include "course/RayCaster.h"

#include <algorithm>
#include <array>
#include <limits>

namespace {

constexpr std::uint32_t fewest = 4;     // triangles that are not worth a node of their own
constexpr double touchingShare = 1e-6;  // of the scene's size
constexpr double rim = 1e-12;           // so that no ray slips through between two triangles

// Halves at every level, so 2^64 triangles would fit.
constexpr std::size_t deepest = 64;

}  // namespace

struct RayCaster::Ray {
    glm::dvec3 origin, direction, inverse;
    const MyPolygon* from;
    double least, nearest = std::numeric_limits<double>::infinity();
    MyPolygon* patch = nullptr;

    bool enters(const Node& node) const {
        const glm::dvec3 a = (node.low - origin) * inverse, b = (node.high - origin) * inverse;
        const glm::dvec3 in = glm::min(a, b), out = glm::max(a, b);
        // A ray along the side of a box gives a NaN, which the comparisons pass over.
        double first = least, last = nearest;
        for (int axis = 0; axis < 3; ++axis) {
            if (in[axis] > first) first = in[axis];
            if (out[axis] < last) last = out[axis];
        }
        return first <= last * (1.0 + rim) + rim;
    }

    void meet(const Triangle& triangle) {
        if (triangle.patch == from) return;
        const glm::dvec3 p = glm::cross(direction, triangle.edge2);
        const double determinant = glm::dot(triangle.edge1, p);
        if (determinant == 0.0) return;
        const glm::dvec3 s = origin - triangle.corner, q = glm::cross(s, triangle.edge1);
        const double u = glm::dot(s, p) / determinant, v = glm::dot(direction, q) / determinant;
        const double distance = glm::dot(triangle.edge2, q) / determinant;
        // A direction that is no direction gives NaN, and meets nothing.
        if (!(u >= -rim && v >= -rim && u + v <= 1.0 + rim && distance >= least && distance < nearest)) return;
        nearest = distance;
        patch = triangle.patch;
    }
};

RayCaster::RayCaster(const std::vector<MyPolygon*>& patches, const std::vector<MyVertex*>& corners) {
    for (MyPolygon* patch : patches) add(patch, corners);
    if (triangles.empty()) return;
    build(0, static_cast<std::uint32_t>(triangles.size()));
    touching = touchingShare * glm::length(nodes[0].high - nodes[0].low);
}

void RayCaster::add(MyPolygon* patch, const std::vector<MyVertex*>& corners) {
    const auto place = [&](int k) { return glm::dvec3(corners[static_cast<std::size_t>(patch->vertex[k])]->position); };
    for (int k = 1; k + 1 < patch->vertices; ++k)
        triangles.push_back({place(0), place(k) - place(0), place(k + 1) - place(0), patch});
}

// Splits where half the triangles lie on either side along the longest axis of the box.
std::uint32_t RayCaster::build(std::uint32_t begin, std::uint32_t end) {
    const auto index = static_cast<std::uint32_t>(nodes.size());
    Node node{glm::dvec3(std::numeric_limits<double>::infinity()),
              glm::dvec3(-std::numeric_limits<double>::infinity())};
    for (std::uint32_t i = begin; i < end; ++i)
        for (const glm::dvec3& edge : {glm::dvec3(0.0), triangles[i].edge1, triangles[i].edge2}) {
            node.low = glm::min(node.low, triangles[i].corner + edge);
            node.high = glm::max(node.high, triangles[i].corner + edge);
        }
    nodes.push_back(node);
    if (end - begin <= fewest) {
        nodes[index].begin = begin;
        nodes[index].end = end;
        return index;
    }
    const glm::dvec3 size = node.high - node.low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(triangles.begin() + begin, triangles.begin() + middle, triangles.begin() + end,
                     [axis](const Triangle& a, const Triangle& b) { return a.middle()[axis] < b.middle()[axis]; });
    build(begin, middle);
    const std::uint32_t second = build(middle, end);
    nodes[index].second = second;
    return index;
}

MyPolygon* RayCaster::hit(const Vec3f& origin, const Vec3f& direction, const MyPolygon* from) const {
    if (nodes.empty()) return nullptr;
    const glm::dvec3 along = glm::normalize(glm::dvec3(direction));
    Ray ray{glm::dvec3(origin), along, 1.0 / along, from, from ? touching : -touching};
    std::array<std::uint32_t, deepest> waiting;
    std::size_t count = 0;
    waiting[count++] = 0;
    while (count > 0) {
        const std::uint32_t index = waiting[--count];
        const Node& node = nodes[index];
        if (!ray.enters(node)) continue;
        for (std::uint32_t i = node.begin; i < node.end; ++i) ray.meet(triangles[i]);
        if (node.second == 0) continue;
        waiting[count++] = node.second;
        waiting[count++] = index + 1;
    }
    return ray.patch;
}
