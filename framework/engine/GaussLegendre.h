#pragma once

#include <vector>

namespace radlab::engine {

constexpr int mostGaussNodes = 20;

/// A node of a rule on 0 to 1, and its weight.
struct GaussNode {
    double position, weight;
};

/// The Gauss-Legendre rule on 0 to 1: exact for polynomials of degree 2·count - 1.
///
/// @param count 1 to mostGaussNodes
/// @cost a look into a table
const std::vector<GaussNode>& gaussLegendre(int count);

}  // namespace radlab::engine
