#pragma once

#include "engine/Polygon.h"

namespace radlab::engine {

/// A straight edge from one corner to the next.
struct Edge {
    Point begin, end;
};

/// ∬ ln r ds dt over two edges, r the distance between a point of one and a point of the other.
///
/// To about 14 digits of the larger of the edges' lengths' product and the integral, also where the edges touch, cross,
/// coincide or have no length.
///
/// @cost parallel edges in closed form; else some 12 logarithms, and more the closer the edges come to each other
/// @source [SchroderHanrahan1993] the integral; the inner one in closed form, the outer one by Gauss-Legendre on panels
///         that are graded towards its singularities
double edgeIntegral(const Edge& a, const Edge& b);

}  // namespace radlab::engine
