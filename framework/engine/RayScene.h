#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <vector>

#include "engine/Polygon.h"

namespace radlab::engine {

/// A point of a plane and its unit normal.
struct Plane {
    Point on, normal;
};

/// From where a polygon stops rays.
enum class Sides {
    both,
    fronts,  ///< what is met from its back lets the ray pass
};

/// What a ray met.
struct RayHit {
    static constexpr std::size_t nothing = static_cast<std::size_t>(-1);
    std::size_t polygon = nothing;
    double distance = 0.0;  ///< from the start, in lengths of the direction, as good as floats are
};

constexpr int mostPanes = 64;  ///< on one line; what more let through is nothing to speak of

/// Polygons as rays meet them: opaque from both sides, unless asked otherwise.
///
/// Rays run in floats, in a frame with its origin in the middle of the scene. May be asked by several threads at once.
class RayScene {
public:
    /// @cost a tree over all triangles
    explicit RayScene(const std::vector<Polygon>& polygons);
    ~RayScene();
    RayScene(const RayScene&) = delete;
    RayScene& operator=(const RayScene&) = delete;

    /// Whether anything but the two named polygons lies on the line between two points.
    bool hides(const Point& from, const Point& to, std::size_t first, std::size_t second) const;

    /// The share of light that gets from one point to another past all but the two named polygons.
    ///
    /// @param through of each polygon; empty where all are opaque
    double transmittance(const Point& from, const Point& to, std::size_t first, std::size_t second,
                         const std::vector<double>& through) const;

    /// What a ray meets first, other than the polygon it starts from; `nothing` where it leaves the scene.
    RayHit meet(const Point& from, const Point& direction, std::size_t start, Sides sides = Sides::both) const;

    /// How many rays were traced so far.
    std::size_t rays() const { return traced; }

private:
    struct Tree;
    std::unique_ptr<Tree> tree;
    Point origin{0.0};
    std::vector<std::size_t> polygonOf;  // of each triangle
    std::vector<Plane> planes;           // of each polygon
    mutable std::atomic<std::size_t> traced{0};
};

}  // namespace radlab::engine
