#pragma once

#include <vector>

#include "course/DataFormat.h"
#include "course/Face.h"

/// Cuts the faces of a scene into patches.
class Mesher {
public:
    /// Cuts every face into patches of about the wanted size.
    ///
    /// A convex quadrilateral becomes a grid of quadrilaterals: round(longer of two opposite edges / size)
    /// cells along each pair of edges, at least 1. A triangle becomes n² triangles of its own shape, n =
    /// round(longest edge / size), at least 1. A larger or concave polygon is cut along a grid of square cells, laid
    /// along its longest edge; a piece that is not a triangle or quadrilateral is cut into them. Patches of one face share
    /// their vertices; patches of different faces only where both faces have a crease angle, and meet at a smaller one,
    /// so nodal averaging never blurs a crease.
    ///
    /// @param inVertices  positions, in the scene's unit of length
    /// @param inPolygons  faces, counter-clockwise seen from the front, planar to 1e-3 of their size
    /// @param outVertices, outPolygons  replaced by the result: rad = unshot_rad = emissive, color = diffuse, formF = 0;
    ///                    MyPolygon::vertex are indices into outVertices
    /// @param patchSize   length of a patch's edge to aim at, > 0 and finite; infinity is refused
    /// @param lightSize   the same for faces that emit
    /// @return for each patch the index of the face that it was cut from
    ///
    /// Faces without area are passed over with one warning that counts them.
    /// Errors: sizes that are not positive numbers; a face with fewer than three different corners, with more than
    /// 1024, or not planar;
    /// more than mostPatches patches (PatchMesh.h).
    /// @cost linear in the number of patches
    /// @source [SutherlandHodgman1974] clipping to cells
    static std::vector<int> mesh(const std::vector<Vec3f>& inVertices, const std::vector<radlab::Face>& inPolygons,
                                 std::vector<MyVertex>& outVertices, std::vector<MyPolygon>& outPolygons,
                                 float patchSize, float lightSize);
};
