#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "grader/judge/Judge.h"

namespace radlab::grader {

/// What check and watch need to judge one file again and again.
class FileChecker {
public:
    /// Errors: a manifest or a build that cannot be read.
    FileChecker(std::filesystem::path file, std::uint64_t seed, unsigned jobs);

    /// Compiles the file and judges the stages named, all where none is, with a progress bar on a terminal.
    ///
    /// Errors: CompileError; those of compileSubmission and Judge.
    Result judge(const std::vector<std::string>& stages) const;

    /// Compiles and judges extensions, each out of its file in the folder, with a progress bar on a terminal.
    ///
    /// @return a result without marks; compiler is what the first that does not compile got, under its name from here
    /// Errors: those of judgeExtension.
    Result judgeExtensions(const std::vector<ManifestStage>& extensions, const std::filesystem::path& folder) const;

    /// The verdict on the file where it does not compile.
    Result notCompiled(const std::vector<std::string>& stages, const std::string& compilerSaid) const;

    const Manifest& manifest() const { return rules; }
    const std::filesystem::path& file() const { return source; }

private:
    JudgeOptions options(const std::vector<std::string>& stages) const;
    std::string shownName() const;

    std::filesystem::path source;
    std::uint64_t seed;
    unsigned jobs;
    Toolchain toolchain;
    Manifest rules;
};

/// 0: all is right; 1: something is wrong or not started; 3: the grader or the machine failed.
int exitCode(const Result& result);

/// Whether a person reads standard output on a terminal that shows colours.
bool wantsColor();

}  // namespace radlab::grader
