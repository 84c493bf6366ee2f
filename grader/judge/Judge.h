#pragma once

#include <filesystem>
#include <functional>
#include <memory>
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

/// Judges compiled submissions: each check in a process of its own, the verdict here.
///
/// Cases, and what is right for them, follow from the seed and are found once for all submissions.
class Judge {
public:
    Judge(Manifest manifest, Toolchain toolchain, JudgeOptions options);
    ~Judge();

    /// Judges one.
    ///
    /// A stage whose stub is still there is notStarted; what a crash, a hang or a closed descriptor costs is the check that it
    /// happened in. Checks that need other stages are judged last, and are blocked where those have not passed.
    /// @return result.submission is left for the caller to set
    Result judge(const std::filesystem::path& library);

    /// Compiles a file and judges it.
    ///
    /// Errors: CompileError; those of compileSubmission.
    Result judgeFile(const std::filesystem::path& source);

    /// The verdict on one that does not compile: no marks, and no stage judged.
    Result notCompiled(const std::string& compilerSaid) const;

    /// The verdict on a file that is not there: nothing of it is started.
    Result notStarted() const;

private:
    class Cases;
    Result unjudged(Status status, const std::string& why) const;

    Manifest manifest;
    Toolchain toolchain;
    JudgeOptions options;
    std::unique_ptr<Cases> cases;
};

}  // namespace radlab::grader
