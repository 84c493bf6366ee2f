#pragma once

#include <cstddef>

#include <glm/vec3.hpp>

namespace radlab {

/// A colour that tells neighbouring IDs apart: hues a golden angle from each other; black for 0.
///
/// @return ready for display
glm::vec3 idColor(std::size_t id);

/// A colour for a share of 0 to 1: black, violet, red, orange, pale yellow, each lighter than the one before.
///
/// @return ready for display; black below 0, the last colour above 1
glm::vec3 heatColor(float share);

/// The heat colour of a form factor on a logarithmic scale: black at 1e-7 and below, pale at 1e-2 and above.
glm::vec3 formFactorColor(float formFactor);

}  // namespace radlab
