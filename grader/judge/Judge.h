#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "grader/judge/Compile.h"
#include "grader/protocol/Result.h"
#include "grader/stages/Manifest.h"

namespace radlab::grader {

/// What to judge, and how.
struct JudgeOptions {
    std::uint64_t seed = 0;
    unsigned jobs = 0;                ///< processes at once; 0: one a core
    std::vector<std::string> stages;  ///< by their names in the manifest; empty: all
    bool pictures = true;             ///< the checks of pictures, too
    std::function<void(std::size_t done, std::size_t total, const std::string& now)> report;
};

/// Judges a compiled submission: each check in a process of its own, the verdict here.
///
/// A stage whose stub is still there is notStarted; what a crash, a hang or a closed descriptor costs is the check that it happened
/// in. Checks that need other stages are judged last, and are blocked where those have not passed.
/// @return result.submission is left for the caller to set
/// Errors: the worker cannot be started.
Result judgeSubmission(const std::filesystem::path& library, const Manifest& manifest, const Toolchain& toolchain,
                       const JudgeOptions& options);

}  // namespace radlab::grader
