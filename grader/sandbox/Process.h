#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/Error.h"
#include "grader/sandbox/Box.h"

namespace radlab::grader {

/// A program to run: nothing of this process's environment reaches it but what is named here.
struct Command {
    std::vector<std::string> arguments;  ///< the program's path first
    std::vector<std::string> environment = {"PATH=/usr/local/bin:/usr/bin:/bin", "LC_ALL=C.UTF-8"};
    std::filesystem::path folder = "/";     ///< where it runs
    std::optional<Box> box = std::nullopt;  ///< none: nothing keeps it from the machine but its limits
};

/// What a program may use. A limit of 0 is none.
struct ProcessLimits {
    double seconds = 10.0;                      ///< that it may run or sleep; waiting for a processor is neither
    std::size_t memory = std::size_t{4} << 30;  ///< bytes of address space
    std::size_t file = 0;                       ///< bytes of the largest file that it may write
    std::size_t output = 64 << 10;              ///< bytes kept of what it prints; the rest is thrown away
    std::size_t answer = std::size_t{1} << 28;  ///< bytes that may come through descriptor 3
    bool stoppable = true;                      ///< whether an interrupt kills it
};

/// The program that this process runs, also where there is no /proc.
std::filesystem::path ownProgram();

/// How a program ended, and what it left.
struct Ended {
    enum class How {
        exited,     ///< code is its exit code
        signalled,  ///< code is the signal
        timedOut,   ///< it was stopped at the limit of time
    };
    How how = How::exited;
    int code = 0;
    std::string output;  ///< standard output and standard error, as they came
    bool outputCut = false;
    std::string answer;  ///< what it wrote to descriptor 3
    double seconds = 0.0;
};

/// "ended with exit code 1", "was stopped by signal 11" or "took too long", for messages.
std::string howItEnded(const Ended& ended);

/// The program cannot be started, or this machine lacks processes, descriptors or the time to run it: not the program's fault.
class MachineError : public Error {
public:
    using Error::Error;
};

/// Runs a program in a process group of its own, feeds it, and waits for its end.
///
/// It starts with standard input (which brings `input`), output and error, and descriptor 3 (which takes its answer), and no other;
/// it gains no privileges, dumps no core, and goes with this process. At its end, or at the limit of time, its whole group is
/// killed; what a process that left the group still prints is not waited for. On a busy machine it takes longer: see Deadline.
/// May be called by several threads at once.
///
/// Errors: MachineError; Interrupted, the program then being killed.
Ended run(const Command& command, std::string_view input, const ProcessLimits& limits);

}  // namespace radlab::grader
