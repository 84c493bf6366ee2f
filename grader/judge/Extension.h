#pragma once

#include <filesystem>

#include "grader/judge/Judge.h"

namespace radlab::grader {

/// Judges an extension out of its own file, apart from the six stages.
///
/// A file that is not there is an extension that is not started.
///
/// @param extension  of the manifest
/// @param options    those of Judge; stages are ignored
/// @return a result with this one extension, and no marks; where it does not compile, compiled is false, the extension
///         blocked, and compiler the first error
/// Errors: MachineError; those of compileSubmission but CompileError.
Result judgeExtension(const ManifestStage& extension, const std::filesystem::path& file, const Manifest& manifest,
                      const Toolchain& toolchain, JudgeOptions options);

}  // namespace radlab::grader
