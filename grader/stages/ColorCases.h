#pragma once

#include <cstdint>
#include <vector>

#include "grader/stages/Stage.h"

namespace radlab::grader {

/// What colorReconstruction is asked for: rooms, fans and strips of patches, fresh and with old colours, with vertices of no patch.
std::vector<Check> colorChecks(std::uint64_t seed);

}  // namespace radlab::grader
