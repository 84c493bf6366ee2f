#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/Error.h"
#include "grader/sandbox/Sandbox.h"
#include "grader/sandbox/TemporaryFolder.h"
#include "grader/stages/Manifest.h"

namespace radlab::grader {

/// How submissions are compiled and judged on this machine, as the build wrote it down.
struct Toolchain {
    std::string compiler;
    std::vector<std::string> flags;
    std::filesystem::path worker;
    std::vector<std::filesystem::path> reads;  ///< folders that the flags name
    Sandbox sandbox;                           ///< that submissions run in
    bool sanitized = false;  ///< built with the sanitizers, which need more memory and time than the manifest allows
};

/// Reads what the build wrote; the sandbox is this machine's.
///
/// Errors: no such file, or one that is not as it should be.
Toolchain readToolchain(const std::filesystem::path& file);

/// A submission that does not compile: the text is the compiler's first error with its file and line.
class CompileError : public Error {
public:
    using Error::Error;
};

/// Compiles a submission into a shared library that the worker can load, in a box where it finds the course's headers and the
/// compiler, and nothing of the machine. Of the files beside it, it finds those that the manifest names.
///
/// @param library  the file to write; whatever the compiler does, no other is written
/// @return what the compiler said, under the files' own names
/// Errors: CompileError, also where the compiler takes too long; no such file; MachineError.
/// @cost half a second where the precompiled header fits
std::string compileSubmission(const std::filesystem::path& file, const std::filesystem::path& library,
                              const Toolchain& toolchain, const Manifest& manifest);

/// The first error in a compiler's output, with the lines that explain it.
std::string firstError(const std::string& output);

}  // namespace radlab::grader
