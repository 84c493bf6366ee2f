#pragma once

#include <memory>
#include <string_view>

#include "grader/sandbox/Process.h"

namespace radlab::grader {

/// A program that waits in its box and forks for each run, so that what is long to load is loaded once.
///
/// The other end is `serveForks`. What one run leaves behind, processes included, is gone before the next, and
/// a program that was brought down is started again.
class ForkServer {
public:
    /// Nothing starts before the first run.
    ForkServer(Command command, const ProcessLimits& limits);
    ~ForkServer();
    ForkServer(const ForkServer&) = delete;
    ForkServer& operator=(const ForkServer&) = delete;

    /// One run in a process of its own, as in `run`.
    ///
    /// @param seconds  that it may run or sleep, in place of those of the limits
    /// Errors: MachineError, also where the program does not start; Interrupted.
    Ended run(std::string_view input, double seconds);

private:
    struct Running;

    void start();
    Ended perform(std::string_view input, double seconds);
    bool send(int input, int output, int answer) const;
    bool receive(Ended& ended) const;

    Command command;
    ProcessLimits limits;
    std::unique_ptr<Running> running;
};

}  // namespace radlab::grader
