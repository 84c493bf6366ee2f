#include "engine/Shaft.h"

#include <algorithm>

#include <tbb/parallel_for.h>

namespace radlab::engine {

namespace {

constexpr std::size_t mostFaces = 256;
constexpr double relativeTolerance = 1e-6;

struct Range {
    double low, high;
};

// How far a polygon stands out before and behind another's plane.
Range heightsOver(const Polygon& plane, const Polygon& polygon) {
    Range range{1e300, -1e300};
    for (const Point& corner : polygon.corners) {
        const double height = glm::dot(corner - plane.center, plane.normal);
        range = {std::min(range.low, height), std::max(range.high, height)};
    }
    return range;
}

}  // namespace

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
    if (count == 0 || count > mostFaces) return;
    Box whole = faceBoxes[0];
    for (const Box& box : faceBoxes) whole = {glm::min(whole.low, box.low), glm::max(whole.high, box.high)};
    tolerance = relativeTolerance * glm::length(whole.high - whole.low);
    candidates.resize(count * count);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t a) {
        for (std::size_t b = 0; b < count; ++b)
            for (std::size_t face = 0; face < count; ++face)
                if (face != a && face != b &&
                    mayHide(geometry.faces[a], faceBoxes[a], geometry.faces[b], faceBoxes[b], face))
                    candidates[a * count + b].push_back(face);
    });
}

bool Shafts::mayBeHidden(std::size_t first, std::size_t second) const {
    if (candidates.empty()) return !geometry.faces.empty();
    const std::size_t faceA = geometry.faceOf[first], faceB = geometry.faceOf[second];
    const std::vector<std::size_t>& between = candidates[faceA * geometry.faces.size() + faceB];
    return std::any_of(between.begin(), between.end(), [&](std::size_t face) {
        return mayHide(geometry.patches[first], patchBoxes[first], geometry.patches[second], patchBoxes[second], face);
    });
}

bool Shafts::mayHide(const Polygon& a, const Box& boxA, const Polygon& b, const Box& boxB, std::size_t face) const {
    const Point low = glm::min(boxA.low, boxB.low), high = glm::max(boxA.high, boxB.high);
    const Box& box = faceBoxes[face];
    if (glm::any(glm::lessThan(box.high, low - tolerance)) || glm::any(glm::greaterThan(box.low, high + tolerance)))
        return false;
    const Polygon& blocker = geometry.faces[face];
    if (heightsOver(a, blocker).high <= tolerance || heightsOver(b, blocker).high <= tolerance) return false;
    const Range ofA = heightsOver(blocker, a), ofB = heightsOver(blocker, b);
    return std::min(ofA.low, ofB.low) < -tolerance && std::max(ofA.high, ofB.high) > tolerance;
}

}  // namespace radlab::engine
