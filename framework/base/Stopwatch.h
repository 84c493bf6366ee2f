#pragma once

#include <chrono>

namespace radlab {

/// Wall-clock seconds since it was made or restarted.
class Stopwatch {
public:
    double seconds() const { return std::chrono::duration<double>(Clock::now() - start).count(); }
    void restart() { start = Clock::now(); }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start = Clock::now();
};

}  // namespace radlab
