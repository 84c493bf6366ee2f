#pragma once

#include <cstdint>
#include <vector>

#include "grader/stages/Stage.h"

namespace radlab::grader {

/// What renderPatchIDs is asked to draw: from a few tiles, each wholly in view, to more patches than two bytes can count.
///
/// The camera's matrices and the pictures' sizes differ from case to case; no patch is nearer than the near plane.
std::vector<Check> patchIdChecks(std::uint64_t seed);

}  // namespace radlab::grader
