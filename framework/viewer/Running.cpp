#include "viewer/Running.h"

#include <algorithm>
#include <array>
#include <exception>
#include <string>

#include "base/Error.h"

namespace radlab {

namespace {

constexpr std::array<const char*, 8> names{
    "",       "maxenergy_patch", "calcAnalyticalFF", "distributeEnergy", "colorReconstruction", "renderPatchIDs",
    "calcFF", "loading"};

// The number is the last to be written: who sees it sees the rest.
void begin(RunningNow& now, Running what) {
    const int depth = now.depth.load();
    if (depth < RunningNow::mostCalls) {
        RunningNow::Call& call = now.calls[static_cast<std::size_t>(depth)];
        call.what = static_cast<int>(what);
        call.number = ++now.count;
    }
    now.depth = depth + 1;
}

MyPolygon* checked(MyPolygon* patch, Running function) {
    if (patch && std::find(polygons.begin(), polygons.end(), patch) == polygons.end())
        throw Error(std::string(nameOf(function)) +
                    ": found a pointer to something else, expected one of polygons or nullptr");
    return patch;
}

}  // namespace

const char* nameOf(Running running) { return names[static_cast<std::size_t>(running)]; }

int stageOf(Running running) { return running == Running::loading ? 0 : static_cast<int>(running); }

int stageOf(const char* function) {
    for (int stage = 1; stage <= 6; ++stage)
        if (std::string(function) == names[static_cast<std::size_t>(stage)]) return stage;
    return 0;
}

Running RunningNow::running() const {
    const int inner = std::min(depth.load(), mostCalls) - 1;
    return inner < 0 ? Running::none : static_cast<Running>(calls[static_cast<std::size_t>(inner)].what.load());
}

RunningMark::RunningMark(RunningNow& now, Running what) : place(now), exceptions(std::uncaught_exceptions()) {
    begin(place, what);
}

RunningMark::~RunningMark() {
    if (std::uncaught_exceptions() > exceptions && place.failed == 0) place.failed = static_cast<int>(place.running());
    --place.depth;
}

RunningPause::RunningPause(RunningNow& now) : place(now) { begin(place, Running::none); }

RunningPause::~RunningPause() { --place.depth; }

void RunningTime::look(const RunningNow& now, double seconds) {
    const auto depth = static_cast<std::size_t>(std::min(now.depth.load(), RunningNow::mostCalls));
    bool paused = false;
    for (std::size_t i = depth; i-- > 0;) {
        const std::uint64_t number = now.calls[i].number;
        if (number != seen[i].number)
            seen[i] = {static_cast<Running>(now.calls[i].what.load()), number, 0.0};
        else if (!paused)
            seen[i].seconds += seconds - before;
        paused = paused || seen[i].what == Running::none;
    }
    for (std::size_t i = depth; i < seen.size(); ++i) seen[i] = {};
    before = seconds;
}

Running RunningTime::longerThan(double seconds) const {
    for (std::size_t i = seen.size(); i-- > 0;)
        if (seen[i].what != Running::none && seen[i].seconds > seconds) return seen[i].what;
    return Running::none;
}

CourseFunctions marked(const CourseFunctions& functions, RunningNow& now) {
    const auto shooter = [&now](auto function, Running what) {
        return [&now, function, what](auto... arguments) {
            const RunningMark mark(now, what);
            return checked(function(arguments...), what);
        };
    };
    const auto other = [&now](auto function, Running what) {
        return [&now, function, what](auto... arguments) {
            const RunningMark mark(now, what);
            return function(arguments...);
        };
    };
    return {shooter(functions.maxenergyPatch, Running::maxenergyPatch),
            shooter(functions.calcAnalyticalFF, Running::calcAnalyticalFF),
            other(functions.distributeEnergy, Running::distributeEnergy),
            other(functions.colorReconstruction, Running::colorReconstruction),
            other(functions.renderPatchIDs, Running::renderPatchIDs),
            shooter(functions.calcFF, Running::calcFF)};
}

}  // namespace radlab
