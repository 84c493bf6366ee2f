#include "grader/sandbox/Deadline.h"

#include "base/ProgressBar.h"
#include "grader/sandbox/Process.h"

namespace radlab::grader {

namespace {

constexpr double mostWaiting = 5.0;  // limits of time that a program may wait for a processor

}  // namespace

bool Deadline::isOver(pid_t process) {
    if (most <= 0.0) return false;
    const double now = watch.seconds();
    wait.look(process, now);
    if (wait.seconds() > mostWaiting * most)
        throw MachineError("this machine is too busy: " + program + " waited for a processor for " +
                           durationText(wait.seconds()) + "; run it again with fewer programs beside it");
    return now - wait.seconds() > most;
}

}  // namespace radlab::grader
