#pragma once

#include <cstdint>
#include <vector>

#include "grader/stages/Stage.h"

namespace radlab::grader {

/// What calcAnalyticalFF is asked for: pairs and crowds of patches near and far, large and small, turned towards and away.
std::vector<Check> analyticalChecks(std::uint64_t seed);

}  // namespace radlab::grader
