#pragma once

#include <array>

#include "engine/BoxTree.h"

namespace radlab::engine {

/// Where the lines between two polygons run: the box around both, in front of both, and within planes that touch both.
///
/// What it misses, no line between them meets; what it does not miss, some line may.
///
/// @source [HainesWallace1994]
class Shaft {
public:
    /// @param tolerance  what stands out of a polygon's plane by no more than that lies in it
    /// @pre the polygons and their boxes live as long as this does
    Shaft(const Polygon& a, const Box& boxA, const Polygon& b, const Box& boxB, double tolerance);

    /// Whether no line runs through a box.
    bool misses(const Box& box) const;
    /// Whether no line crosses a polygon.
    bool misses(const Polygon& polygon, const Box& box);
    /// Whether no line meets an edge.
    bool misses(const Point& from, const Point& to);

    /// Which way all lines run through planes with a normal: 1 along it, -1 against it; 0 where they differ.
    int direction(const Point& normal) const;

private:
    // Planes with the lines on one side, in lanes.
    struct Sides {
        static constexpr std::size_t count = 8;
        std::array<double, count> x{}, y{}, z{}, offset;

        Sides() { offset.fill(-1.0); }
        bool anyHas(const Box& box) const;
        template <class Test>
        bool any(const Test& test) const {
            for (std::size_t i = 0; i < count; ++i)
                if (test(Point(x[i], y[i], z[i]), offset[i])) return true;
            return false;
        }
    };
    bool onOneSide(const Polygon& polygon) const;
    void makeSides();
    void setSide(std::size_t i, Point outwards, const Point& along);

    const Polygon &a, &b;
    Box around;
    double tolerance, heightA, heightB;
    Sides
        sides;  // made when they are likely to pay: for edges, or after a few polygons that are not missed without them
    bool hasSides = false;
    int notMissed = 0;
};

}  // namespace radlab::engine
