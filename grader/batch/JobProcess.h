#pragma once

#include <sys/types.h>

#include <functional>
#include <optional>
#include <string>

#include "grader/sandbox/Deadline.h"
#include "grader/sandbox/Pipes.h"

namespace radlab::grader {

/// How a piece of work in a process of its own ended.
struct JobEnd {
    bool done = false;
    std::string text;  ///< the answer; or, in words, why there is none
};

/// A process, forked from this one, that does a piece of work and answers with bytes.
///
/// It has a process group of its own, goes when this process goes, and keeps nothing open that this process had open.
/// What it prints is kept, to be told if it fails. Where this object goes, so does the process, done or not.
class JobProcess {
public:
    /// @param  seconds that it may run or sleep
    /// @pre    this process has one thread: no other could hold a lock that the forked one waits for
    /// Errors: MachineError, where there can be no more processes.
    JobProcess(const std::function<std::string()>& work, double seconds, std::size_t mostBytes);
    ~JobProcess();
    JobProcess(const JobProcess&) = delete;
    JobProcess& operator=(const JobProcess&) = delete;

    /// Where its answer comes from, to be waited for; -1 when nothing more will come.
    int descriptor() const { return answers.get(); }

    /// Takes what has come, without waiting, and says whether that was the end, or its time is up.
    std::optional<JobEnd> look();

private:
    [[noreturn]] static void perform(const std::function<std::string()>& work, int answer, int output, pid_t parent);
    void read();
    std::optional<JobEnd> answer() const;
    std::optional<JobEnd> death();
    std::optional<JobEnd> lateness();
    std::string lastWords() const;

    double mostSeconds;
    std::size_t most;
    Descriptor answers, printed;
    pid_t process = -1;
    bool reaped = false;
    std::optional<Deadline> deadline;
    std::string got;
};

}  // namespace radlab::grader
