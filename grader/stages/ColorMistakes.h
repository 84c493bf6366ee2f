#pragma once

#include <vector>

#include "grader/stages/Stage.h"

namespace radlab::grader {

/// Colours of patches and vertices, as they should be.
Computation reconstructs();

/// What people do in place of it; special mistakes before general ones.
std::vector<Mistake> colorMistakes();

}  // namespace radlab::grader
