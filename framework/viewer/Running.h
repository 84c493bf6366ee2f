#pragma once

#include <array>
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

/// What is running, one called by the other, where a supervisor process can read it.
struct RunningNow {
    static constexpr int mostCalls = 8;  ///< that are told apart; deeper ones go by the name of the eighth

    struct Call {
        std::atomic<int> what{0};              ///< a pause is none
        std::atomic<std::uint64_t> number{0};  ///< of all calls so far
    };
    std::array<Call, mostCalls> calls;  ///< the outermost first
    std::atomic<int> depth{0};          ///< of them
    std::atomic<std::uint64_t> count{0};
    std::atomic<int> failed{0};  ///< the innermost that an exception left since this was set to 0

    /// The innermost.
    Running running() const;
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
    const int exceptions;
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
};

/// How long what is running has been, as seen by who looks now and then.
class RunningTime {
public:
    /// @param seconds that the process has used so far
    void look(const RunningNow& now, double seconds);

    /// The innermost function that has been running for longer, without its pauses; none if there is none.
    Running longerThan(double seconds) const;

private:
    struct Seen {
        Running what = Running::none;
        std::uint64_t number = 0;
        double seconds = 0.0;
    };
    std::array<Seen, RunningNow::mostCalls> seen;
    double before = 0.0;
};

/// The same functions, each marked while it runs; a shooter that is none of `polygons` is an Error that names the function.
CourseFunctions marked(const CourseFunctions& functions, RunningNow& now);

}  // namespace radlab
