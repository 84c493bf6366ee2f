#pragma once

#include <string>

#include "grader/judge/Compile.h"

namespace radlab::grader {

struct Command;

/// Makes a worker draw with what RADLAB_GL names, where the user of the judge has set it.
void chooseOpenGl(Command& worker);

/// What the workers of this machine draw with: kind, version and renderer, in a line; or why they cannot draw.
///
/// Errors: MachineError.
std::string openGlOf(const Toolchain& toolchain);

}  // namespace radlab::grader
