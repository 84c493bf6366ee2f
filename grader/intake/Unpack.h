#pragma once

#include <string_view>

#include "grader/intake/Choice.h"

namespace radlab::grader {

/// Lets the program rules.unpack look through an archive.
///
/// Where that program crashes, runs too long or answers nonsense, the archive is to blame, and a remark says so.
///
/// Errors: MachineError, where the program cannot be started or was killed from outside.
Gathered unpackArchive(std::string_view bytes, const IntakeRules& rules);

}  // namespace radlab::grader
