#include "course/Mesher.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/Interrupts.h"
#include "base/Warning.h"
#include "course/CreaseAngle.h"
#include "course/FaceCutter.h"

using namespace radlab;

namespace {

constexpr double planarTolerance = 1e-3;
constexpr std::size_t mostCorners = 1024;  // cutting a concave polygon costs up to their cube

void checkSize(float size, const std::string& name) {
    if (!std::isfinite(size) || size <= 0.0f)
        throw Error(name + ": found " + std::to_string(size) + ", expected a length above 0");
}

Corners differentCorners(const std::vector<Vec3f>& positions, const Face& face) {
    if (face.corners.size() > mostCorners)
        throw Error(face.where, "face has too many corners: found " + std::to_string(face.corners.size()) +
                                    ", expected at most " + std::to_string(mostCorners) + "; split it");
    Corners corners;
    for (const int index : face.corners) {
        RADLAB_CHECK(index >= 0);
        RADLAB_CHECK(static_cast<std::size_t>(index) < positions.size());
        const glm::dvec3 position(positions[static_cast<std::size_t>(index)]);
        if (corners.empty() || position != corners.back()) corners.push_back(position);
    }
    while (corners.size() > 1 && corners.back() == corners.front()) corners.pop_back();
    if (corners.size() < 3)
        throw Error(face.where, "degenerate face: found " + std::to_string(corners.size()) +
                                    " different corners, expected at least 3");
    return corners;
}

void checkPlanar(const Corners& corners, const glm::dvec3& normal, const Location& where) {
    const glm::dvec3 centre = areaCentroid(corners, normal);
    double deviation = 0.0;
    for (const glm::dvec3& corner : corners)
        deviation = std::max(deviation, std::abs(glm::dot(corner - centre, normal)));
    const double allowed = std::max(planarTolerance * diameter(corners), floatResolution(corners));
    if (deviation > allowed)
        throw Error(where, "face is not planar: found a corner " + std::to_string(deviation) +
                               " off its plane, expected at most " + std::to_string(allowed) +
                               "; split it into triangles");
}

void warnOfSlivers(int count, const Location& first) {
    if (count == 0) return;
    warn(first.file + (first.line > 0 ? ":" + std::to_string(first.line) : "") + ": passed over " +
         std::to_string(count) + (count == 1 ? " face" : " faces, this the first,") + " without area");
}

}  // namespace

std::vector<int> Mesher::mesh(const std::vector<Vec3f>& inVertices, const std::vector<Face>& inPolygons,
                              std::vector<MyVertex>& outVertices, std::vector<MyPolygon>& outPolygons, float patchSize,
                              float lightSize) {
    checkSize(patchSize, "patch size");
    checkSize(lightSize, "light patch size");
    outVertices.clear();
    outPolygons.clear();
    std::vector<int> faceOf;
    int slivers = 0;
    Location firstSliver;
    for (std::size_t i = 0; i < inPolygons.size(); ++i) {
        Interrupts::check();
        const Face& face = inPolygons[i];
        RADLAB_CHECK(face.material != nullptr);
        const Corners corners = differentCorners(inVertices, face);
        const glm::dvec3 area = areaVector(corners);
        if (hasNoArea(corners, glm::length(area))) {
            if (slivers++ == 0) firstSliver = face.where;
            continue;
        }
        checkPlanar(corners, glm::normalize(area), face.where);
        FaceCutter(face, face.material->emits() ? lightSize : patchSize, outVertices, outPolygons)
            .cut(corners, glm::normalize(area));
        faceOf.resize(outPolygons.size(), static_cast<int>(i));
    }
    warnOfSlivers(slivers, firstSliver);
    shareWithinCreaseAngle(inPolygons, faceOf, outVertices, outPolygons);
    return faceOf;
}
