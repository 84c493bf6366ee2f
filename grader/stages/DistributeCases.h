#pragma once

#include <cstdint>
#include <vector>

#include "grader/stages/Stage.h"

namespace radlab::grader {

/// The shots that distributeEnergy is asked for: first and later ones, of lamps and walls, bright and dark, large and small.
std::vector<Check> distributeChecks(std::uint64_t seed);

}  // namespace radlab::grader
