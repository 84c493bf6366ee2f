#pragma once

#include <array>
#include <vector>

#include "engine/Polygon.h"

namespace radlab::engine {

using Triangle = std::array<Point, 3>;

/// A polygon in convex pieces, turned as it is; itself where it is convex, and nothing where it has no area.
///
/// @pre no two of its edges cross
std::vector<Polygon> convexPiecesOf(const Polygon& polygon);

/// The triangles of a polygon, turned as it is, convex or not; those without area are left out.
///
/// @pre no two of its edges cross
std::vector<Triangle> trianglesOf(const Polygon& polygon);

/// Things to be drawn by their weights.
class Shares {
public:
    /// Adds a thing.
    ///
    /// @param weight > 0
    void add(double weight) { upTo.push_back(sum += weight); }

    struct Drawn {
        std::size_t which;
        double rest;  ///< 0 to 1, spread evenly where the number drawn by is
    };

    /// The thing for a number from 0 to 1.
    ///
    /// @pre there are things
    Drawn draw(double u) const;

    double total() const { return sum; }

private:
    std::vector<double> upTo;  // weights up to and with each thing
    double sum = 0.0;
};

/// A point of a polygon for two numbers from 0 to 1: where these are spread evenly, the points are.
class AreaSampler {
public:
    explicit AreaSampler(const Polygon& polygon);

    /// @cost a few operations for a parallelogram; for others a search among their triangles and a root
    Point at(double u, double v) const;

private:
    Point origin{0.0}, along{0.0}, across{0.0};  // of a parallelogram
    std::vector<Triangle> triangles;             // of others
    Shares shares;
};

}  // namespace radlab::engine
