#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>

#include "grader/sandbox/ControlGroup.h"
#include "grader/sandbox/Process.h"
#include "grader/sandbox/TemporaryFolder.h"

namespace radlab::grader {

/// The own user of the boxes that this thread starts: nobody else's, and no account of the machine.
uid_t ownUserOfThread();

/// The exit code of a child that could not become the program.
inline constexpr int cannotStart = 127;

/// A program that was started in its box; killed with all that it started when this goes.
class Launched {
public:
    /// @param input, output, answer  descriptors that become its 0, 1 and 2, and 3
    /// Errors: MachineError.
    Launched(const Command& command, const ProcessLimits& limits, int input, int output, int answer);
    ~Launched();
    Launched(const Launched&) = delete;
    Launched& operator=(const Launched&) = delete;

    pid_t process() const { return number; }

    /// Whether it has ended; how, too, if so.
    bool hasEnded(Ended& ended);

    /// Kills it and its process group.
    void stop() const;

private:
    std::optional<ControlGroup> group;       // goes after the process
    std::optional<TemporaryFolder> scratch;  // where no box holds it
    pid_t number = -1;
    bool reaped = false;
};

}  // namespace radlab::grader
