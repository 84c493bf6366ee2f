#pragma once

#include <string>
#include <vector>

#include "grader/stages/HemisphereRays.h"

namespace radlab::grader {

/// A misconception of hemisphereFF, as what becomes of its rays.
struct RayMistake {
    std::string id, text, hint;
    RayUse use;
};

/// What people do in place of the right thing; special mistakes before general ones.
std::vector<RayMistake> rayMistakes();

}  // namespace radlab::grader
