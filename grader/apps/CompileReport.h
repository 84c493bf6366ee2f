#pragma once

#include <filesystem>
#include <string>

namespace radlab::grader {

/// What a student sees of a compile error: the compiler's first error with its line, and the next step.
std::string compileReport(const std::string& firstError, const std::filesystem::path& file);

}  // namespace radlab::grader
