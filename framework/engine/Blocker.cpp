#include "engine/Blocker.h"

#include <algorithm>
#include <cmath>

namespace radlab::engine {

Blocker::Blocker(const Polygon& polygon, double rounding, double letsThrough)
    : center(polygon.center), normal(polygon.normal), tolerance(rounding), share(letsThrough) {
    const std::size_t count = polygon.corners.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Point edge = polygon.corners[(i + 1) % count] - polygon.corners[i];
        if (glm::length(edge) == 0.0) continue;
        const Point inwards = glm::normalize(glm::cross(normal, edge));
        sides.push_back({inwards, glm::dot(inwards, polygon.corners[i])});
    }
}

bool Blocker::meets(const Point& from, const Point& to) const {
    const double start = height(from), end = height(to);
    if (std::min(start, end) >= -tolerance || std::max(start, end) <= tolerance) return false;
    const Point at = from + start / (start - end) * (to - from);
    return std::all_of(sides.begin(), sides.end(),
                       [&](const Side& side) { return glm::dot(side.inwards, at) > side.offset; });
}

// The line between two corners at heights h and k, on different sides of the plane, meets it at the share h / (h - k)
// of its length.
Sight Blocker::between(const Polygon& a, const Polygon& b) const {
    const Range ofA = heightsOver(a, center, normal), ofB = heightsOver(b, center, normal);
    const bool apart = (ofA.low > tolerance && ofB.high < -tolerance) || (ofB.low > tolerance && ofA.high < -tolerance);
    if (!apart) return Sight::partly;
    thread_local std::vector<double> weights, depthsB;
    weights.clear();
    for (const Point& from : a.corners)
        for (const Point& to : b.corners) weights.push_back(height(from) / (height(from) - height(to)));
    bool inside = true;
    for (const Side& side : sides) {
        depthsB.clear();
        for (const Point& to : b.corners) depthsB.push_back(glm::dot(side.inwards, to) - side.offset);
        Range depths;
        const double* weight = weights.data();
        for (const Point& from : a.corners) {
            const double depth = glm::dot(side.inwards, from) - side.offset;
            for (const double depthB : depthsB) depths.add(depth + *weight++ * (depthB - depth));
        }
        if (depths.high <= tolerance) return Sight::clear;
        inside = inside && depths.low >= 0.0;
    }
    return inside ? Sight::hidden : Sight::partly;
}

}  // namespace radlab::engine
