#pragma once

// A processor that is too busy, whatever else the machine does.

#include <sched.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>
#include <vector>

namespace radlab::test {

/// Starts a process that does this, and then nothing more; it goes with the thread that started it.
inline pid_t forked(const std::function<void()>& work) {
    const pid_t process = fork();
    if (process != 0) return process;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    work();
    _exit(0);
}

/// Does something that takes all of a processor, without end.
[[noreturn]] inline void spin() {
    for (volatile unsigned i = 0;;) i = i + 1;
}

/// Keeps this thread, and what it starts, on one processor.
inline void stayOn(int processor) {
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(processor, &one);
    sched_setaffinity(0, sizeof one, &one);
}

/// Lets this thread, and what it starts, run only where nobody else wants to.
inline void yieldToAll() {
    const sched_param none{};
    sched_setscheduler(0, SCHED_IDLE, &none);
}

/// One processor with eight processes that spin, as long as this lives.
class BusyProcessor {
public:
    BusyProcessor() {
        for (int i = 0; i < 8; ++i)
            spinning.push_back(forked([this] {
                stayOn(chosen);
                spin();
            }));
    }
    ~BusyProcessor() {
        for (const pid_t process : spinning) kill(process, SIGKILL);
        for (const pid_t process : spinning) waitpid(process, nullptr, 0);
    }
    BusyProcessor(const BusyProcessor&) = delete;
    BusyProcessor& operator=(const BusyProcessor&) = delete;

    int number() const { return chosen; }

    /// A processor that this thread may run on.
    static int anyOfMine() {
        cpu_set_t mine;
        sched_getaffinity(0, sizeof mine, &mine);
        int first = 0;
        while (!CPU_ISSET(first, &mine)) ++first;
        return first;
    }

private:
    const int chosen = anyOfMine();
    std::vector<pid_t> spinning;
};

}  // namespace radlab::test
