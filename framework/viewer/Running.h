#pragma once

#include <atomic>
#include <cstdint>

#include "solver/CourseFunctions.h"

namespace radlab {

/// What of the student's code is running; `none` while the viewer's own is.
enum class Running {
    none,
    maxenergyPatch,
    calcAnalyticalFF,
    distributeEnergy,
    colorReconstruction,
    renderPatchIDs,
    calcFF,
    loading
};

/// The function's name as ProgRef.h writes it; "" for none.
const char* nameOf(Running running);

/// The stage of the exercise that the function is, 1 to 6; 0 for the others.
int stageOf(Running running);

/// The stage of a function by its name; 0 for one that is none of the six.
int stageOf(const char* function);

/// What is running and since when, where a supervisor process can read it.
struct RunningNow {
    std::atomic<int> what{0};
    std::atomic<int> failed{0};          ///< the innermost that an exception left since this was set to 0
    std::atomic<std::int64_t> since{0};  ///< nanoseconds of the steady clock

    Running running() const { return static_cast<Running>(what.load()); }

    /// Seconds that it has been running for; 0 for none.
    double seconds() const;
};

/// Says that a function runs, while it lives; then what ran before.
class RunningMark {
public:
    RunningMark(RunningNow& now, Running what);
    ~RunningMark();
    RunningMark(const RunningMark&) = delete;
    RunningMark& operator=(const RunningMark&) = delete;

private:
    RunningNow& place;
    const int before, exceptions;
};

/// Says that none of it runs for a while, in the middle of a function, while it lives; the function's time stands still.
class RunningPause {
public:
    explicit RunningPause(RunningNow& now);
    ~RunningPause();
    RunningPause(const RunningPause&) = delete;
    RunningPause& operator=(const RunningPause&) = delete;

private:
    RunningNow& place;
    const int before;
    const std::int64_t start;
};

/// The same functions, each marked while it runs; a shooter that is none of `polygons` is an Error that names the function.
CourseFunctions marked(const CourseFunctions& functions, RunningNow& now);

}  // namespace radlab
