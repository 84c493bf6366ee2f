#pragma once

#include <cstdint>
#include <vector>

#include "grader/stages/Stage.h"

namespace radlab::grader {

/// The most rays whose form factors are held against multiples of 1/rays: sums of more floats are not exact enough.
constexpr int fewRays = 1000;

/// What hemisphereFF is asked to shoot: few rays and many, shooters turned any way, in closed rooms and open scenes.
///
/// The shooters of all checks but "rays.turned" look along the z axis, so that turning the hemisphere is a matter of
/// its own.
std::vector<Check> hemisphereChecks(std::uint64_t seed);

}  // namespace radlab::grader
