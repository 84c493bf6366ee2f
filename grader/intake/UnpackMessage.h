#pragma once

#include <string>
#include <string_view>

#include "grader/intake/Choice.h"

namespace radlab::grader {

// What the program `unpack` is told, and what it answers.

/// What it found, as bytes.
std::string toCbor(const Gathered& gathered);

/// What it found, where the archive may have taken the program over: nothing beyond the rules is let through.
///
/// Errors: what toCbor did not write, and what the rules do not allow.
Gathered gatheredFromCbor(std::string_view bytes, const IntakeRules& rules);

/// The rules, but for the path of the program.
std::string rulesToText(const IntakeRules& rules);

/// Errors: what rulesToText did not write.
IntakeRules rulesFromText(const std::string& text);

}  // namespace radlab::grader
