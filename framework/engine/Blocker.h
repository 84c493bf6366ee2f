#pragma once

#include <vector>

#include "engine/Polygon.h"

namespace radlab::engine {

/// What of each other two patches see.
enum class Sight {
    clear,   ///< everything
    hidden,  ///< nothing: opaque faces stand between all their points
    partly,  ///< unclear: some lines between them may meet a face
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

}  // namespace radlab::engine
