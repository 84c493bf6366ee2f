#pragma once

#include <filesystem>

#include "grader/protocol/Result.h"

namespace radlab::grader {

/// Writes the page of a result into a folder, made where it does not exist: the pictures of the checks, and last the
/// page that shows them.
///
/// The page needs no script and nothing from elsewhere. What comes from the submission stands on it as plain text.
///
/// @return the page, index.html
/// Errors: a folder that cannot be written; pictures in a build without stb.
std::filesystem::path writeHtmlReport(const Result& result, const std::filesystem::path& folder);

}  // namespace radlab::grader
