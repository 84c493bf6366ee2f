#pragma once

#include "engine/Polygon.h"

namespace radlab::engine {

/// The direct exchange area of two polygons with nothing between them: A(a)·F(a→b) = A(b)·F(b→a).
///
/// What lies behind the other's plane is clipped off, and each is seen from its front alone. Near polygons take the double
/// integral along their outlines, a small one beside a large one takes the integral along the large one's outline from
/// Gauss-Legendre nodes on the small one, and polygons far from each other take such nodes on both.
///
/// @return squared units of the scene, >= 0; relative error about 1e-12, and up to 1e-9 where outlines touch and one of the
///         polygons is a sliver of 1 to a million
/// @cost   a microsecond or less for polygons far apart, some ten for near ones, a hundred where they touch at an angle
/// @source [HottelSarofim1967] direct exchange areas; [SchroderHanrahan1993] the integral along the outlines
double exchangeArea(const Polygon& a, const Polygon& b);

}  // namespace radlab::engine
