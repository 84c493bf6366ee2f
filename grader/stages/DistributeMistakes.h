#pragma once

#include <vector>

#include "grader/stages/Stage.h"

namespace radlab::grader {

/// One shot from the step's shooter to all patches, as it should be.
Computation distributes();

/// What people do in place of it; special mistakes before general ones.
std::vector<Mistake> distributeMistakes();

}  // namespace radlab::grader
