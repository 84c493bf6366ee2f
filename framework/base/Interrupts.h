#pragma once

#include <atomic>
#include <functional>
#include <stdexcept>

namespace radlab {

/// Thrown out of long work that Ctrl-C ends; a function whose half-made result is worth something keeps it instead.
struct Interrupted : std::runtime_error {
    Interrupted() : std::runtime_error("interrupted") {}
};

/// Does work that may be left half-done.
///
/// @return false where Interrupted ended it
bool doneWhole(const std::function<void()>& work);

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
    static bool caught() { return came.load(std::memory_order_relaxed); }

    /// Throws Interrupted where one came that was not answered yet.
    ///
    /// @cost next to nothing, so that long work may ask in its loops
    static void check() {
        if (caught()) throwUnlessAnswered();
    }

    /// Lets check throw no more for what came: what is left to do is to finish and write what there is.
    static void answer();

    /// In a process that was forked: lets them end it.
    static void forget();

private:
    static void note(int signal);
    static void throwUnlessAnswered();

    static inline std::atomic<bool> came{false}, answered{false};
    static_assert(std::atomic<bool>::is_always_lock_free);  // or a signal's handler could not set it
    static constexpr int count = 3;
    using Handler = void (*)(int);
    Handler before[count] = {};
};

}  // namespace radlab
