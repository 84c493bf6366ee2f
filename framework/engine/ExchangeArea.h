#pragma once

#include <vector>

#include "engine/GaussOrder.h"
#include "engine/Polygon.h"

namespace radlab::engine {

constexpr double finestTolerance = 1e-12;

/// The direct exchange area of two polygons with nothing between them: A(a)·F(a→b) = A(b)·F(b→a).
///
/// What lies behind the other's plane is clipped off, and each is seen from its front alone. Near polygons take the double
/// integral along their outlines, a small one beside a large one takes the integral along the large one's outline from
/// Gauss-Legendre nodes on the small one, and polygons far from each other take such nodes on both.
///
/// @param tolerance  of the relative error, finestTolerance or more
/// @return squared units of the scene, >= 0; where outlines touch, a sliver of 1 to a million has an error of up to 1e-9
/// @cost   0.1 µs for polygons far apart and a tolerance of 1e-6, 1 µs for one of 1e-12; some ten for near ones, a hundred where
///         they touch at an angle
/// @source [HottelSarofim1967] direct exchange areas; [SchroderHanrahan1993] the integral along the outlines
double exchangeArea(const Polygon& a, const Polygon& b, double tolerance = finestTolerance);

/// Nodes over polygons, side by side for loops of four at a time: the last ones of a polygon may weigh nothing.
class NodeTable {
public:
    /// Where the coordinates and the weights of one polygon's nodes begin.
    struct Nodes {
        const double *x, *y, *z, *weight;
        std::size_t count;   ///< that weigh something
        std::size_t padded;  ///< with those that weigh nothing
    };

    NodeTable() = default;
    NodeTable(const std::vector<Polygon>& polygons, int order);

    Nodes of(std::size_t polygon) const;

private:
    std::vector<std::size_t> first, counts;
    std::vector<double> numbers;
};

/// The exchange areas between the polygons of a list: what is needed of each polygon again and again is kept.
///
/// May be asked by several threads at once.
class ExchangeAreas {
public:
    /// @param polygons  live as long as this does
    /// @cost 1 KiB for each polygon
    ExchangeAreas(const std::vector<Polygon>& polygons, double tolerance);

    /// exchangeArea(polygons[i], polygons[j])
    double operator()(std::size_t i, std::size_t j) const;

private:
    static constexpr int keptOrders = 4;

    const std::vector<Polygon>& polygons;
    GaussOrders orders;
    NodeTable nodes[keptOrders];
};

}  // namespace radlab::engine
