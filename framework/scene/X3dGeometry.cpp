#include "scene/X3dGeometry.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "base/Interrupts.h"

namespace radlab {

namespace {

using FaceCorners = std::vector<int>;

/// An index list cut into faces at every -1; the last one may be missing.
std::vector<FaceCorners> cutAtSeparators(const std::vector<int>& indices) {
    std::vector<FaceCorners> faces;
    FaceCorners face;
    for (int index : indices) {
        Interrupts::check();
        if (index == -1)
            faces.push_back(std::exchange(face, {}));
        else
            face.push_back(index);
    }
    if (!face.empty()) faces.push_back(std::move(face));
    return faces;
}

std::vector<FaceCorners> cutEvery(const X3dNode& node, const std::vector<int>& indices, std::size_t count) {
    if (indices.size() % count != 0)
        node.fail("index has " + std::to_string(indices.size()) + " entries, expected a multiple of " +
                  std::to_string(count));
    std::vector<FaceCorners> faces;
    for (auto at = indices.begin(); at != indices.end(); at += static_cast<std::ptrdiff_t>(count))
        faces.emplace_back(at, at + static_cast<std::ptrdiff_t>(count));
    return faces;
}

std::vector<FaceCorners> readFaces(const X3dNode& node) {
    if (node.name() == "IndexedTriangleSet") return cutEvery(node, node.wholes("index"), 3);
    if (node.name() == "IndexedQuadSet") return cutEvery(node, node.wholes("index"), 4);
    return cutAtSeparators(node.wholes("coordIndex"));
}

void checkFace(const X3dNode& node, const FaceCorners& face, std::size_t number, std::size_t points) {
    const std::string which = "face " + std::to_string(number) + " (counted from 1)";
    for (int index : face) {
        if (index >= 0 && static_cast<std::size_t>(index) < points) continue;
        const std::string expected =
            points == 0 ? "but there are no points" : "expected 0 to " + std::to_string(points - 1);
        node.fail(which + " has an index out of range, found " + std::to_string(index) + " with " +
                  std::to_string(points) + " points, " + expected);
    }
    if (face.size() < 3)
        node.fail(which + " has too few corners, found " + std::to_string(face.size()) + ", expected at least 3");
}

void mergeRepeatedCorners(FaceCorners& face) {
    face.erase(std::unique(face.begin(), face.end()), face.end());
    while (face.size() > 1 && face.front() == face.back()) face.pop_back();
}

float creaseAngle(const X3dNode& node) {
    const double angle = node.number("creaseAngle", 0.0);
    if (angle < 0.0) node.fail("creaseAngle: found " + std::to_string(angle) + ", expected radians of at least 0");
    return static_cast<float>(std::min(angle, std::numbers::pi));
}

}  // namespace

std::shared_ptr<const X3dPoints> readCoordinate(const X3dNode& node) {
    const auto values = node.numbers("point");
    if (values.size() % 3 != 0)
        node.fail("point has " + std::to_string(values.size()) + " numbers, expected a multiple of 3");
    auto points = std::make_shared<X3dPoints>();
    points->reserve(values.size() / 3);
    for (std::size_t i = 0; i < values.size(); i += 3) points->emplace_back(values[i], values[i + 1], values[i + 2]);
    return points;
}

X3dGeometry readGeometry(const X3dNode& node, std::shared_ptr<const X3dPoints> points) {
    X3dGeometry geometry{std::move(points), {}, 0, 0, !node.flag("solid", true), creaseAngle(node), node.where()};
    const bool clockwise = !node.flag("ccw", true);
    std::size_t number = 0;
    for (FaceCorners& face : readFaces(node)) {
        Interrupts::check();
        checkFace(node, face, ++number, geometry.points->size());
        mergeRepeatedCorners(face);
        if (face.size() < 3) {
            ++geometry.flattened;
            continue;
        }
        if (clockwise) std::reverse(face.begin() + 1, face.end());
        geometry.corners += face.size();
        geometry.faces.push_back(std::move(face));
    }
    return geometry;
}

}  // namespace radlab
