#pragma once

#include <string>

#include "grader/judge/Compile.h"
#include "grader/sandbox/ForkServer.h"
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

/// Workers for one submission: each run in a process of its own, in a box with the submission and nothing else.
///
/// Belongs to one thread.
class Worker {
public:
    Worker(const std::filesystem::path& library, const Toolchain& toolchain, const Manifest& manifest);

    /// Performs steps.
    ///
    /// run.cause says why it ended before the last answer, in words that name the function.
    /// @param seconds that it may run or sleep; six times that under the sanitizers
    /// Errors: MachineError, also where no worker starts.
    WorkerRun run(const std::vector<Step>& steps, double seconds);

private:
    double slower;              ///< than a program without the sanitizers
    ForkServer plain, drawing;  // what has no OpenGL loaded forks much faster
};

}  // namespace radlab::grader
