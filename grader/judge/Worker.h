#pragma once

#include <string>

#include "grader/judge/Compile.h"
#include "grader/stages/Verdict.h"

namespace radlab::grader {

/// What came back from a worker, and what it printed.
struct WorkerRun {
    CheckRun run;
    std::string output;
    double seconds = 0.0;
    bool machineFailed = false;  ///< the worker itself failed: never the submission's fault
    bool timedOut = false;
};

/// Has a worker perform steps on a submission, in a process of its own.
///
/// run.cause says why it ended before the last answer, in words that name the function.
/// @param seconds of wall-clock time that it may take; six times that under the sanitizers
///
/// Errors: MachineError.
WorkerRun runWorker(const std::filesystem::path& library, const std::vector<Step>& steps, const Toolchain& toolchain,
                    const Manifest& manifest, double seconds);

/// Whether the worker starts at all, without a submission: else nothing that it did not answer is the submission's fault.
///
/// @return what is wrong, empty where it works
std::string workerProblem(const Toolchain& toolchain, const Manifest& manifest);

}  // namespace radlab::grader
