#pragma once

#include <string>

#include "grader/stages/Stage.h"

namespace radlab::grader {

/// A failing step of a case as a doctest test case: the patches, the call, and the claim that fails.
///
/// It needs course/PatchMesh.h and course/ProgRef.h, and a GL context where it draws.
///
/// @param value    index of the wrong value in the stage's numbers
/// @param before   what the step found
/// @return empty where there are too many patches to print, and for extensions
std::string caseAsCode(const Stage& stage, const Case& asked, std::size_t step, const State& before, std::size_t value,
                       double found, double expected);

}  // namespace radlab::grader
