#include "engine/Shaft.h"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

#include "base/Error.h"
#include "engine/Triangles.h"

namespace radlab::engine {

namespace {

constexpr double relativeTolerance = 1e-6;

// A face in convex pieces: itself where it is convex.
std::vector<Blocker> blockersOf(const Polygon& face, double tolerance, double through) {
    std::vector<Blocker> pieces;
    for (const Polygon& piece : convexPiecesOf(face)) pieces.emplace_back(piece, tolerance, through);
    return pieces;
}

}  // namespace

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

// The line between two corners at heights h and k, on different sides of the plane, meets it at the share h / (h - k) of its length.
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

Shafts::Box Shafts::boxOf(const Polygon& polygon) {
    Box box;
    if (polygon.corners.empty()) return box;
    box.low = box.high = polygon.corners[0];
    for (const Point& corner : polygon.corners) {
        box.low = glm::min(box.low, corner);
        box.high = glm::max(box.high, corner);
    }
    return box;
}

Shafts::Shafts(const Geometry& shapes) : geometry(shapes) {
    for (const Polygon& patch : geometry.patches) patchBoxes.push_back(boxOf(patch));
    for (const Polygon& face : geometry.faces) faceBoxes.push_back(boxOf(face));
    const std::size_t count = geometry.faces.size();
    RADLAB_CHECK(count <= mostFaces);
    if (count == 0) return;
    Box whole = faceBoxes[0];
    for (const Box& box : faceBoxes) whole = {glm::min(whole.low, box.low), glm::max(whole.high, box.high)};
    tolerance = relativeTolerance * glm::length(whole.high - whole.low);
    for (std::size_t i = 0; i < count; ++i)
        blockers.push_back(
            blockersOf(geometry.faces[i], tolerance, geometry.through.empty() ? 0.0 : geometry.through[i]));
    candidates.resize(count * count);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t a) {
        for (std::size_t b = 0; b < count; ++b)
            for (std::size_t face = 0; face < count; ++face)
                if (face != a && face != b &&
                    mayHide(geometry.faces[a], faceBoxes[a], geometry.faces[b], faceBoxes[b], face))
                    candidates[a * count + b].push_back(face);
    });
}

Sight Shafts::sight(std::size_t first, std::size_t second, std::vector<const Blocker*>& between) const {
    between.clear();
    const Polygon &a = geometry.patches[first], &b = geometry.patches[second];
    const std::size_t row = geometry.faceOf[first] * geometry.faces.size();
    for (const std::size_t face : candidates[row + geometry.faceOf[second]]) {
        if (!mayHide(a, patchBoxes[first], b, patchBoxes[second], face)) continue;
        for (const Blocker& blocker : blockers[face]) {
            const Sight sight = blocker.between(a, b);
            if (sight == Sight::hidden && blocker.through() == 0.0) return Sight::hidden;
            if (sight != Sight::clear) between.push_back(&blocker);
        }
    }
    return between.empty() ? Sight::clear : Sight::partly;
}

bool Shafts::mayHide(const Polygon& a, const Box& boxA, const Polygon& b, const Box& boxB, std::size_t face) const {
    const Point low = glm::min(boxA.low, boxB.low), high = glm::max(boxA.high, boxB.high);
    const Box& box = faceBoxes[face];
    if (glm::any(glm::lessThan(box.high, low - tolerance)) || glm::any(glm::greaterThan(box.low, high + tolerance)))
        return false;
    const Polygon& blocker = geometry.faces[face];
    if (heightsOver(blocker, a.center, a.normal).high <= tolerance ||
        heightsOver(blocker, b.center, b.normal).high <= tolerance)
        return false;
    const Range ofA = heightsOver(a, blocker.center, blocker.normal),
                ofB = heightsOver(b, blocker.center, blocker.normal);
    return std::min(ofA.low, ofB.low) < -tolerance && std::max(ofA.high, ofB.high) > tolerance;
}

}  // namespace radlab::engine
