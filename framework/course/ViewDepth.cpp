#include "course/ViewDepth.h"

#include <algorithm>
#include <cmath>

#include "course/FacePolygon.h"

namespace radlab {

namespace {

constexpr double smallestRatio = 1e-6;
constexpr double floatRounding = 0x1p-24;

// How far a corner may seem to lie over the shooter's plane, because its place, the eye and the normal are floats.
double planeError(const glm::dvec3& corner, const glm::dvec3& eye) {
    return 4.0 * floatRounding * (glm::length(corner) + glm::length(eye) + glm::distance(corner, eye));
}

// Distance from p to a convex planar polygon.
double distanceToPatch(const glm::dvec3& p, const MyPolygon& patch, const std::vector<MyVertex*>& corners) {
    const auto corner = [&](int i) {
        return glm::dvec3(corners[static_cast<std::size_t>(patch.vertex[i % patch.vertices])]->position);
    };
    const glm::dvec3 normal(patch.normal);
    bool over = true;
    double nearestEdge = INFINITY;
    for (int i = 0; i < patch.vertices; ++i) {
        const glm::dvec3 a = corner(i), b = corner(i + 1);
        over = over && glm::dot(glm::cross(b - a, p - a), normal) >= 0.0;
        nearestEdge = std::min(nearestEdge, distanceToSegment(p, a, b));
    }
    return over ? std::abs(glm::dot(p - corner(0), normal)) : nearestEdge;
}

}  // namespace

ViewDepth viewDepth(const std::vector<MyPolygon*>& patches, const std::vector<MyVertex*>& corners,
                    const glm::dvec3& eye, const glm::dvec3& direction) {
    if (patches.empty()) return {1e-3, 1e3};
    double nearest = INFINITY, farthest = 0.0;
    for (const MyPolygon* patch : patches) {
        const glm::dvec3 centre(patch->center);
        double radius = 0.0, highest = -INFINITY;
        for (int i = 0; i < patch->vertices; ++i) {
            const glm::dvec3 position(corners[static_cast<std::size_t>(patch->vertex[i])]->position);
            radius = std::max(radius, glm::distance(position, centre));
            highest = std::max(highest, glm::dot(position - eye, direction) - planeError(position, eye));
        }
        const double distance = glm::distance(centre, eye);
        farthest = std::max(farthest, distance + radius);
        if (distance - radius < nearest && highest > 1e-5 * radius)
            nearest = std::min(nearest, distanceToPatch(eye, *patch, corners));
    }
    farthest *= 1.01;
    nearest = std::isfinite(nearest) ? 0.5 * nearest : 0.5 * farthest;
    return {std::clamp(nearest, smallestRatio * farthest, 0.5 * farthest), farthest};
}

}  // namespace radlab
