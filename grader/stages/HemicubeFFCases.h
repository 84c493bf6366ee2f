#pragma once

#include <cstdint>
#include <vector>

#include "grader/stages/Stage.h"

namespace radlab::grader {

/// What calcFF is asked to shoot: open and closed scenes, shooters turned any way, up to more patches than two bytes can count.
///
/// Two cases in a row of one check have hemicubes of different sizes, so that the second one's is new.
std::vector<Check> hemicubeChecks(std::uint64_t seed);

}  // namespace radlab::grader
