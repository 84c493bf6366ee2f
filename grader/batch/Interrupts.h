#pragma once

#include <csignal>

namespace radlab::grader {

/// Turns Ctrl-C, and requests to end, into something to ask for; the second of a kind ends the process at once.
///
/// What is ignored, as by nohup, stays so. One at a time; what was before is back when it goes.
class Interrupts {
public:
    Interrupts();
    ~Interrupts();
    Interrupts(const Interrupts&) = delete;
    Interrupts& operator=(const Interrupts&) = delete;

    /// Whether one came since this was made; not where there is none of these.
    static bool caught();

    /// In a process that was forked: lets them end it.
    static void forget();

private:
    struct sigaction before[3];
};

}  // namespace radlab::grader
