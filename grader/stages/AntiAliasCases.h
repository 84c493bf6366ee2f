#pragma once

#include <cstdint>
#include <vector>

#include "grader/stages/Stage.h"

namespace radlab::grader {

/// What antialias is asked to show: patches in front of the picture's plane, in one sample a pixel and in many.
std::vector<Check> antialiasChecks(std::uint64_t seed);

}  // namespace radlab::grader
