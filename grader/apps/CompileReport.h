#pragma once

#include <filesystem>
#include <string>

namespace radlab::grader {

/// The compiler's first error with its line, under the name that the file has from here.
std::string shownError(const std::string& firstError, const std::filesystem::path& file);

/// What a student sees of a compile error: that, and the next step.
std::string compileReport(const std::string& firstError, const std::filesystem::path& file);

}  // namespace radlab::grader
