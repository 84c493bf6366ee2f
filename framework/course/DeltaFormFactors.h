#pragma once

#include <vector>

namespace radlab {

/// The delta form factors of a hemicube's pixels, row by row from the bottom of its buffer of 2·size squared.
///
/// A pixel of area ΔA on the top face at (x, y, 1) has ΔA/(π(x²+y²+1)²), on a side face at (1, y, z) z·ΔA/(π(y²+z²+1)²), in
/// units of the cube's half edge. Each is sampled at the pixel's centre; all are then scaled by one factor so
/// that they sum to 1 (1.00001 before at size 256). The unused corners have 0.
///
/// @source [CohenGreenberg1985]
std::vector<float> deltaFormFactors(int size);

}  // namespace radlab
