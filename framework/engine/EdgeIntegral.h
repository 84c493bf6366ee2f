#pragma once

#include "engine/Polygon.h"

namespace radlab::engine {

/// A straight edge from one corner to the next.
struct Edge {
    Point begin, end;
};

/// ∬ ln r ds dt over two edges, r the distance between a point of one and a point of the other.
///
/// Also where the edges touch, cross, coincide or have no length.
///
/// @param tolerance  of the error, relative to the larger of the product of the lengths and the integral; 1e-13 or more
/// @cost parallel edges in closed form; else 12 logarithms for 12 digits, and more the closer the edges come to each other
/// @source [SchroderHanrahan1993] the integral; the inner one in closed form, the outer one by Gauss-Legendre on panels
///         that are graded towards its singularities
double edgeIntegral(const Edge& a, const Edge& b, double tolerance);

}  // namespace radlab::engine
