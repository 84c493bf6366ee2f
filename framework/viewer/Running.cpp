#include "viewer/Running.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <exception>
#include <string>

#include "base/Error.h"

namespace radlab {

namespace {

constexpr std::array<const char*, 8> names{
    "",       "maxenergy_patch", "calcAnalyticalFF", "distributeEnergy", "colorReconstruction", "renderPatchIDs",
    "calcFF", "loading"};

std::int64_t nanoseconds() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
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

double RunningNow::seconds() const {
    return running() == Running::none ? 0.0 : 1e-9 * static_cast<double>(nanoseconds() - since.load());
}

RunningMark::RunningMark(RunningNow& now, Running what)
    : place(now), before(now.what.load()), exceptions(std::uncaught_exceptions()) {
    place.since = nanoseconds();
    place.what = static_cast<int>(what);
}

RunningMark::~RunningMark() {
    if (std::uncaught_exceptions() > exceptions && place.failed == 0) place.failed = place.what.load();
    place.since = nanoseconds();
    place.what = before;
}

RunningPause::RunningPause(RunningNow& now) : place(now), before(now.what.load()), start(nanoseconds()) {
    place.what = static_cast<int>(Running::none);
}

RunningPause::~RunningPause() {
    place.since += nanoseconds() - start;
    place.what = before;
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
