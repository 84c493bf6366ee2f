#pragma once

#include <sys/types.h>

#include <string>
#include <utility>

#include "base/ProcessTime.h"

namespace radlab::grader {

/// A limit of a program's own time: see ProcessTime. That it is stopped is its own doing, too.
///
/// Behind it is one of what it may wait for a processor: sixty times as much, but not more than ten minutes, or five times as much where
/// that is more.
class Deadline {
public:
    /// To be made when the program begins, or what it is asked to do.
    ///
    /// @param name  of the program, for messages
    /// @param limit in seconds; 0 is none
    Deadline(std::string name, pid_t process, double limit)
        : program(std::move(name)), most(limit), time(static_cast<int>(process)) {}

    /// Whether the process, with those that it started, has used its time up. It may not have been waited for.
    ///
    /// Errors: MachineError, where it has waited for too long.
    bool isOver();

    /// Seconds of wall-clock time.
    double seconds() const { return time.seconds(); }

private:
    std::string program;
    double most;
    ProcessTime time;
};

}  // namespace radlab::grader
