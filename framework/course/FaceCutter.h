#pragma once

#include <utility>
#include <vector>

#include "course/DataFormat.h"
#include "course/Face.h"
#include "course/FacePolygon.h"

namespace radlab {

/// Cuts one face into patches, as Mesher::mesh describes; they and their vertices are added to the output.
///
/// @pre the face is planar and has an area
/// Errors: a face that crosses itself, or would make more than mostPatches patches (PatchMesh.h).
class FaceCutter {
public:
    FaceCutter(const Face& face, double size, std::vector<MyVertex>& outVertices, std::vector<MyPolygon>& outPolygons);

    void cut(const Corners& corners, const glm::dvec3& normal);

private:
    void cutTriangle(const Corners& c);
    void cutQuadrilateral(const Corners& c);
    void cutPolygon(const Corners& corners, const glm::dvec3& normal);

    void checkNotCrossing(const Polygon2& whole, const std::vector<Polygon2>& pieces) const;
    void checkRoom(double patches) const;
    void addCells(const std::vector<std::vector<int>>& cells, const std::vector<glm::dvec2>& points,
                  const Corners& corners, const glm::dvec3& normal);
    int addVertex(const glm::dvec3& position);
    void addPatch(const std::vector<int>& corner);

    const Face& face;
    double size;
    Corners exact;  // this face's vertices before they are rounded to float
    std::vector<MyVertex>& outVertices;
    std::vector<MyPolygon>& outPolygons;
};

}  // namespace radlab
