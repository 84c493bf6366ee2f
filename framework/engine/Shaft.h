#pragma once

#include <vector>

#include "engine/Geometry.h"

namespace radlab::engine {

/// Which pairs of patches something may stand between.
///
/// A face can hide one patch from another only where it reaches into the box around both, stands in front of both, and
/// has them on different sides. Where that fails for every face, nothing is hidden, up to 1e-6 of the scene's size.
class Shafts {
public:
    /// @cost the cube of the number of faces, once; above 256 faces none of that is done, and every pair counts as one that
    ///       something may stand between
    explicit Shafts(const Geometry& geometry);

    /// @pre first and second are patches of the geometry, which still lives
    /// @cost the faces that may stand between the two patches' faces
    bool mayBeHidden(std::size_t first, std::size_t second) const;

private:
    struct Box {
        Point low{0.0}, high{0.0};
    };
    static Box boxOf(const Polygon& polygon);
    bool mayHide(const Polygon& a, const Box& boxA, const Polygon& b, const Box& boxB, std::size_t face) const;

    const Geometry& geometry;
    double tolerance = 0.0;
    std::vector<Box> patchBoxes, faceBoxes;
    std::vector<std::vector<std::size_t>> candidates;  // faces between two faces
};

}  // namespace radlab::engine
