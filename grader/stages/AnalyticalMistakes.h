#pragma once

#include <vector>

#include "grader/stages/Stage.h"

namespace radlab::grader {

/// The row of form factors of the step's shooter, as it should be.
Computation fillsFormFactors();

/// What people do in place of it; special mistakes before general ones.
std::vector<Mistake> analyticalMistakes();

}  // namespace radlab::grader
