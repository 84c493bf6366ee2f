#pragma once

#include <vector>

#include "grader/stages/IdDrawing.h"

namespace radlab::grader {

/// What people draw in place of patch IDs; special mistakes before general ones.
std::vector<Mistake> patchIdMistakes(const IdDrawer& drawer);

}  // namespace radlab::grader
