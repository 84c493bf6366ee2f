#pragma once

#include <vector>

#include "engine/Blocker.h"
#include "engine/BoxTree.h"
#include "engine/FaceEdges.h"
#include "engine/Geometry.h"
#include "engine/Shaft.h"

namespace radlab::engine {

/// Which faces stand between pairs of patches, and what that leaves to be seen.
///
/// A tree over the faces gives those that reach into the shaft between two patches. Where there is none, nothing is
/// hidden, up to 1e-6 of the scene's size. For a face that has the patches wholly on different sides, the lines
/// between them meet its plane in the hull of the points where the lines between their corners do: whether these lie
/// all inside of the face, or all outside of one of its edges, decides the pair without a ray.
///
/// Several faces together: how many opaque faces a line crosses changes only where it passes an edge that ends a
/// surface, or at which the surface folds back from the line, and where its ends pass through a face. Where no edge
/// in the shaft may be such a one for any line, and no face goes through a patch, one line stands for all.
class Shafts {
public:
    /// @param geometry  lives as long as this does
    /// @cost n log² n for its faces, log n for each patch
    explicit Shafts(const Geometry& geometry);

    /// What two patches see of each other.
    ///
    /// @param between where the answer is `partly`: all that may stop or weaken a line between them
    /// @param enough  pieces of faces: where more are found, and the answer is `partly`, the others are not looked for
    /// @cost the faces that reach into the shaft between the two patches
    Sight sight(std::size_t first, std::size_t second, Blockers& between,
                std::size_t enough = static_cast<std::size_t>(-1)) const;

private:
    bool isOpaque(std::size_t face) const { return geometry.through.empty() || !(geometry.through[face] > 0.0); }
    bool isCut(std::size_t patch) const;
    bool goesThrough(std::size_t face, const Polygon& patch) const;
    std::vector<Point> metByEdges(std::size_t face, const Polygon& patch) const;
    bool mayDecide(std::size_t first, std::size_t second) const;
    bool endsIn(Shaft& shaft, std::size_t face) const;
    bool addPieces(std::size_t face, const Polygon& a, const Polygon& b, Blockers& between,
                   std::vector<std::size_t>& opaque) const;
    Sight onOneLine(const Point& from, const Point& to, Blockers& between) const;

    const Geometry& geometry;
    double tolerance = 0.0;
    std::vector<Box> patchBoxes, faceBoxes;
    std::vector<std::vector<Blocker>> blockers;  // each face in convex pieces
    BoxTree tree;                                // over the faces
    FaceEdges edges;                             // of opaque faces
    std::vector<char> cut;                       // whether opaque faces go through a patch, for each
};

}  // namespace radlab::engine
