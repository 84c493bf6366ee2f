#pragma once

#include <array>
#include <vector>

#include "course/PatchMesh.h"
#include "engine/Geometry.h"

namespace radlab::engine {

/// How much each corner of a patch counts at a point of it: bilinear on quadrilaterals, barycentric on triangles.
///
/// @pre    3 or 4 corners; the quadrilateral convex
/// @return weights, each >= 0, that add up to 1; those of the nearest point of the patch for a point beside it
/// @source [Gouraud1971] interpolation between corners
std::array<double, 4> cornerWeights(const Polygon& patch, const Point& point);

/// The radiosity at each point of a solved mesh.
class PatchShading {
public:
    /// One radiosity a patch.
    explicit PatchShading(std::vector<Point> radiosity) : ofPatches(std::move(radiosity)) {}

    /// Smooth from corner to corner: at a corner the mean of the patches that share it.
    ///
    /// Patches that share no corner, such as faces that are one patch, are shown flat, and nothing is done for their
    /// corners.
    ///
    /// @pre    geometry is that of the mesh, and outlives this
    /// @source [CohenWallace1993, chapter 9] nodal averaging
    PatchShading(const PatchMesh& mesh, const Geometry& geometry, std::vector<Point> radiosity);

    Point radiosityAt(std::size_t patch, const Point& point) const;

    /// The radiosity at a corner of a patch, counted in the order of its corners.
    Point radiosityAtCorner(std::size_t patch, std::size_t corner) const;

    /// Whether a patch goes over smoothly into others.
    bool isSmooth(std::size_t patch) const { return shapes && cornersOf[patch][0] != flat; }

    /// How many patches are not flat.
    std::size_t smoothPatches() const { return smooth; }

private:
    static constexpr int flat = -1;
    std::vector<Point> ofPatches, ofCorners;
    std::vector<std::array<int, 4>> cornersOf;  // of each patch; `flat` first where it is
    const std::vector<Polygon>* shapes = nullptr;
    std::size_t smooth = 0;
};

}  // namespace radlab::engine
