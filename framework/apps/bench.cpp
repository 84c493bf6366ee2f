// How fast the course's functions are: hemicubes per second, by immediate mode, as a student writes them.

#include <iostream>
#include <memory>
#include <string>

#include <benchmark/benchmark.h>

#include "base/Program.h"
#include "course/PatchMesh.h"
#include "course/ProgRef.h"
#include "gl/Context.h"
#include "scene/X3dReader.h"

namespace {

// The Cornell box with blocks in about the wanted number of patches.
std::unique_ptr<radlab::PatchMesh> cornellBox(double patches) {
    const radlab::Scene scene = radlab::readX3d(RADLAB_SOURCE_DIR "/resources/scenes/cornell_2.x3d");
    const auto unit = std::make_unique<radlab::PatchMesh>(scene.vertices, scene.faces, 100.0f, 100.0f);
    double area = 0.0;
    for (const MyPolygon& patch : unit->patches) area += static_cast<double>(patch.area);
    const auto size = static_cast<float>(std::sqrt(area / patches));
    auto mesh = std::make_unique<radlab::PatchMesh>(scene.vertices, scene.faces, size, size);
    mesh->publish();
    return mesh;
}

void hemicubes(benchmark::State& state) {
    const auto context = radlab::GlContext::offscreen();
    const auto mesh = cornellBox(static_cast<double>(state.range(0)));
    Hemicube hemicube(static_cast<int>(state.range(1)));
    for (auto _ : state) {
        MyPolygon* shooter = calcFF(&hemicube);
        benchmark::DoNotOptimize(shooter);
        distributeEnergy(shooter);
    }
    state.counters["patches"] = static_cast<double>(mesh->patches.size());
    state.counters["hemicubes/s"] =
        benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(hemicubes)
    ->ArgNames({"about", "size"})
    ->Args({5000, 64})
    ->Args({5000, 256})
    ->Args({5000, 512})
    ->Args({1000, 256})
    ->Args({20000, 256})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void analyticRows(benchmark::State& state) {
    const auto mesh = cornellBox(static_cast<double>(state.range(0)));
    for (auto _ : state) {
        MyPolygon* shooter = calcAnalyticalFF();
        benchmark::DoNotOptimize(shooter);
        distributeEnergy(shooter);
    }
    state.counters["patches"] = static_cast<double>(mesh->patches.size());
    state.counters["rows/s"] = benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(analyticRows)->ArgName("about")->Arg(5000)->Unit(benchmark::kMicrosecond)->UseRealTime();

void printHelp() {
    std::cout << "Measures hemicubes and analytic rows per second.\n\n"
                 "Example: ./radlab bench --benchmark_filter=hemicubes --benchmark_repetitions=5\n\n"
                 "  --version                            Display program version information and exit\n";
    benchmark::PrintDefaultHelp();
}

}  // namespace

int main(int argc, char** argv) {
    if (argc == 2 && std::string(argv[1]) == "--version") {
        std::cout << "radlab " RADLAB_VERSION "\n";
        return 0;
    }
    benchmark::Initialize(&argc, argv, printHelp);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    return radlab::runProgram([] {
        benchmark::RunSpecifiedBenchmarks();
        return 0;
    });
}
