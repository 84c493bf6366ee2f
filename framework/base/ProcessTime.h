#pragma once

#include "base/Stopwatch.h"

namespace radlab {

/// How a process has spent its time, with its threads and all that it started: by that, limits of time are the same on a busy machine.
///
/// The time between two looks is its own, as far as any of them ran, and as far as all of them slept. What is missing was waiting, if one
/// is ready to run at the second look, since then every processor was busy with others; threads that wait for one another's processor
/// wait for nobody else. Beyond a second of sleep between two looks, it is the one who looks that was kept from it, and that counts as
/// waiting, too. Where the system says nothing (it is not Linux, or has no /proc), most of all time counts as waiting.
class ProcessTime {
public:
    /// To be made when the process begins. It may be looked at until it is waited for.
    explicit ProcessTime(int number) : process(number) {}

    /// Looks at the process, where the last look is long enough ago.
    ///
    /// @cost less than a millisecond, at most ten times a second
    void look();

    /// Seconds up to the last look that it ran or slept.
    double used() const { return own; }

    /// Seconds up to the last look that it was ready, and no processor was free.
    double waited() const { return waiting; }

    /// Seconds up to the last look that all of it was stopped, by a signal or a debugger.
    double stopped() const { return halted; }

    /// Seconds of wall-clock time.
    double seconds() const { return watch.seconds(); }

private:
    int process;
    Stopwatch watch;
    double looked = 0.0, ran = 0.0;
    double own = 0.0, waiting = 0.0, halted = 0.0;
};

}  // namespace radlab
