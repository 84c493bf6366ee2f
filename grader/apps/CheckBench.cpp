// How long a student waits for a verdict, from the saved file on: compiling and judging the solution.

#include <cstdlib>
#include <string>

#include <benchmark/benchmark.h>

namespace {

void check(benchmark::State& state, const std::string& stage) {
    const std::string command =
        std::string(RADLAB_CHECK_PROGRAM " --file " RADLAB_SOURCE_DIR "/solutions/ProgRef.cpp ") + stage +
        " >/dev/null";
    for (auto _ : state)
        if (std::system(command.c_str()) != 0) state.SkipWithError("the solution lost marks");
}

}  // namespace

BENCHMARK_CAPTURE(check, maxenergy_patch, "maxenergy_patch")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(check, calcAnalyticalFF, "calcAnalyticalFF")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(check, distributeEnergy, "distributeEnergy")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(check, colorReconstruction, "colorReconstruction")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(check, renderPatchIDs, "renderPatchIDs")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(check, calcFF, "calcFF")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(check, all, "")->Unit(benchmark::kMillisecond)->UseRealTime();
