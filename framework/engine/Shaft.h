#pragma once

#include <vector>

#include "engine/Geometry.h"

namespace radlab::engine {

/// What of each other two patches see.
enum class Sight {
    clear,   ///< everything
    hidden,  ///< nothing: one opaque face stands between all their points
    partly,  ///< unclear: some lines between them meet a face
};

/// A convex polygon that stops lines, from both sides, or lets a share of their light through.
class Blocker {
public:
    /// @pre convex, with an area
    explicit Blocker(const Polygon& polygon, double tolerance, double through = 0.0);

    /// Whether it meets the line between two points; one that only touches it passes.
    bool meets(const Point& from, const Point& to) const;

    /// The share of light that it lets through where it meets a line.
    double through() const { return share; }

    /// Whether it meets none, all or some of the lines between two polygons.
    ///
    /// @pre both convex, or to be taken as the hulls of their corners
    Sight between(const Polygon& a, const Polygon& b) const;

private:
    struct Side {
        Point inwards;
        double offset;
    };

    double height(const Point& point) const { return glm::dot(point - center, normal); }

    Point center, normal;
    double tolerance, share;
    std::vector<Side> sides;
};

using Blockers = std::vector<const Blocker*>;

/// Which faces stand between pairs of patches.
///
/// A face can hide one patch from another only where it reaches into the box around both, stands in front of both, and
/// has them on different sides. Where that fails for every face, nothing is hidden, up to 1e-6 of the scene's size. For a face that
/// has the patches wholly on different sides, the lines between them meet its plane in the hull of the points where the lines
/// between their corners do: whether these lie all inside of the face, or all outside of one of its edges, decides the pair without
/// a ray.
class Shafts {
public:
    static constexpr std::size_t mostFaces = 256;

    /// @pre at most mostFaces faces; the geometry lives as long as this does
    /// @cost the cube of the number of faces, once
    explicit Shafts(const Geometry& geometry);

    /// What two patches see of each other.
    ///
    /// @param between where the answer is `partly`: all that may stop or weaken a line between them
    /// @cost the faces that may stand between the two patches' faces
    Sight sight(std::size_t first, std::size_t second, std::vector<const Blocker*>& between) const;

private:
    struct Box {
        Point low{0.0}, high{0.0};
    };
    static Box boxOf(const Polygon& polygon);
    bool mayHide(const Polygon& a, const Box& boxA, const Polygon& b, const Box& boxB, std::size_t face) const;

    const Geometry& geometry;
    double tolerance = 0.0;
    std::vector<Box> patchBoxes, faceBoxes;
    std::vector<std::vector<Blocker>> blockers;        // each face in convex pieces
    std::vector<std::vector<std::size_t>> candidates;  // faces between two faces
};

}  // namespace radlab::engine
