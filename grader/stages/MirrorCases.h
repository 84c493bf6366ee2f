#pragma once

#include <cstdint>
#include <vector>

#include "grader/stages/Stage.h"

namespace radlab::grader {

/// What mirrorScene is asked to show: a mirror with patches in front of it, behind it and through its plane, seen in
/// perspective.
std::vector<Check> mirrorChecks(std::uint64_t seed);

}  // namespace radlab::grader
