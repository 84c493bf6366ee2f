#pragma once

#include <deque>

#include "base/Stopwatch.h"

namespace radlab {

class Viewer;

/// Frames a second over the last few frames, and over a measurement of a viewer at work.
class FrameMeter {
public:
    /// @param benchSeconds how long to measure for; 0: no measurement
    explicit FrameMeter(double benchSeconds) : benchFor(benchSeconds) {}

    /// A frame was shown; starts the measurement with the first at which the functions can run, and quits at its end.
    void count(Viewer& viewer);

    double framesPerSecond() const;

    /// Prints what was measured.
    void tell(Viewer& viewer) const;

private:
    void bench(Viewer& viewer, double now);

    Stopwatch clock;
    double benchFor, benchStart = 0.0, benchLength = 1.0, lastFrame = 0.0, slowest = 0.0;
    int benchFrames = 0, benchShots = 0;
    std::deque<double> times;
};

}  // namespace radlab
