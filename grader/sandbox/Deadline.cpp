#include "grader/sandbox/Deadline.h"

#include <algorithm>

#include "base/ProgressBar.h"
#include "grader/sandbox/Process.h"

namespace radlab::grader {

namespace {

double mostWaiting(double limit) { return std::min(60.0 * limit, std::max(600.0, 5.0 * limit)); }

}  // namespace

bool Deadline::isOver() {
    if (most <= 0.0) return false;
    time.look();
    if (time.used() + time.stopped() > most) return true;
    if (time.waited() > mostWaiting(most))
        throw MachineError("this machine is too busy: " + program + " waited for a processor for " +
                           durationText(time.waited()) + "; run it again with fewer programs beside it");
    return false;
}

}  // namespace radlab::grader
