#pragma once

#include <string>

namespace radlab::grader {

/// What --version says: the version, what submissions are compiled and drawn with, what keeps them in their box, and what would bring
/// each protection that is missing.
std::string aboutMachine();

/// Says on stderr, in one line, which protections this machine lacks that could be had; nothing where it has all.
void tellLacks();

}  // namespace radlab::grader
