#pragma once

#include <optional>
#include <string>
#include <vector>

namespace radlab::study {

/// Runs another program to its end, without a shell between.
///
/// @param words  the program, looked for along PATH, and its arguments
/// @return its exit code, 128 and more where a signal ended it; nothing where there is no such program
std::optional<int> runCommand(const std::vector<std::string>& words);

}  // namespace radlab::study
