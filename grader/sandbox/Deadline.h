#pragma once

#include <string>

#include "base/Stopwatch.h"
#include "grader/sandbox/ProcessorWait.h"

namespace radlab::grader {

/// A limit of wall-clock time that leaves out what a program waited for a processor.
class Deadline {
public:
    /// @param name  of the program, for messages
    /// @param limit in seconds; 0 is none
    Deadline(std::string name, double limit) : program(std::move(name)), most(limit) {}

    /// Whether a process, with those that it started, has used its time up.
    ///
    /// Errors: MachineError, where it has waited for several times its limit.
    bool isOver(pid_t process);

    double seconds() const { return watch.seconds(); }

private:
    std::string program;
    double most;
    Stopwatch watch;
    ProcessorWait wait;
};

}  // namespace radlab::grader
