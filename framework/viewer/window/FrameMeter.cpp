#include "viewer/window/FrameMeter.h"

#include <algorithm>
#include <cstdio>

#include "viewer/Viewer.h"

namespace radlab {

namespace {

constexpr std::size_t framesMeasured = 40;

}  // namespace

void FrameMeter::count(Viewer& viewer) {
    const double now = clock.seconds();
    if (lastFrame > 0.0) times.push_back(now - lastFrame);
    lastFrame = now;
    if (times.size() > framesMeasured) times.pop_front();
    if (benchFor > 0.0 && viewer.canRun()) bench(viewer, now);
}

double FrameMeter::framesPerSecond() const {
    double sum = 0.0;
    for (const double time : times) sum += time;
    return sum > 0.0 ? static_cast<double>(times.size()) / sum : 0.0;
}

void FrameMeter::bench(Viewer& viewer, double now) {
    if (benchStart == 0.0) {
        benchStart = now;
        viewer.perform(Command::playPause);
        return;
    }
    ++benchFrames;
    slowest = std::max(slowest, times.empty() ? 0.0 : times.back());
    benchShots = std::max(benchShots, viewer.simulation().progress().shots);
    benchLength = now - benchStart;
    if (benchLength >= benchFor || (benchShots > 0 && !viewer.isPlaying())) viewer.perform(Command::quit);
}

void FrameMeter::tell(Viewer& viewer) const {
    std::printf("%zu patches, %s: %.1f frames/s, slowest frame %.1f ms, %.1f shots/s in %.1f s\n",
                viewer.simulation().mesh().patches.size(), nameOf(viewer.simulation().method()),
                benchFrames / benchLength, 1e3 * slowest, benchShots / benchLength, benchLength);
}

}  // namespace radlab
