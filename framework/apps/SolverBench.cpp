// How fast the engine finds radiosities.

#include <benchmark/benchmark.h>

#include "apps/EngineBench.h"
#include "display/ToneMap.h"
#include "engine/HierarchicalRadiosity.h"
#include "engine/Picture.h"
#include "engine/Scattering.h"
#include "engine/SolveToError.h"

namespace {

using namespace radlab;
using namespace radlab::engine;

void radiosities(benchmark::State& state) {
    const Setting setting("cornell_2.x3d", 5000);
    FormFactorOptions exact;
    exact.method = Method::exact;
    exact.tolerance = 1e-4;
    const FormFactorMatrix matrix = formFactors(setting.geometry, exact);
    Surfaces surfaces = surfacesOf(setting.mesh);
    for (Point& reflectance : surfaces.reflectance)
        reflectance *= 0.5;  // what hides others is left out, so rows exceed 1
    SolverOptions options;
    options.tolerance = 1e-6;
    for (auto _ : state) benchmark::DoNotOptimize(solveRadiosity(matrix, surfaces, options));
    state.counters["patches"] = static_cast<double>(setting.geometry.patches.size());
}

// Links with a threshold that falls as patches grow in number: a few for each patch.
void links(benchmark::State& state, bool suited) {
    const auto patches = static_cast<double>(state.range(0));
    const Setting setting("cornell_2.x3d", patches);
    const Surfaces surfaces = surfacesOf(setting.mesh);
    HierarchicalOptions options;
    options.threshold = suited ? 5.0 / patches : 1e-3;
    HierarchicalReport report;
    for (auto _ : state) benchmark::DoNotOptimize(solveHierarchical(setting.geometry, surfaces, options, &report));
    state.counters["patches"] = static_cast<double>(setting.geometry.patches.size());
    state.counters["links"] = static_cast<double>(report.links);
    state.counters["rays"] = static_cast<double>(report.rays);
}

// From the file to a tone mapped picture.
void toError(benchmark::State& state) {
    ErrorGoal goal;
    goal.error = 0.01;
    for (auto _ : state) {
        const Scene scene = readX3d(RADLAB_SOURCE_DIR "/resources/scenes/cornell_2.x3d");
        const Effects effects = findEffects(scene);
        const AccurateSolution solution = solveToError(scene, effects, goal);
        Frame frame;
        frame.camera = scene.cameras.front();
        const Image radiance = drawPicture(TracedScene(solution.geometry, scatteringsOf(scene)),
                                           PatchShading(*solution.mesh, solution.geometry, solution.radiosity), frame);
        benchmark::DoNotOptimize(toneMap(radiance, autoExposure(radiance)));
        state.counters["patches"] = static_cast<double>(solution.geometry.patches.size());
        state.counters["estimated error"] = solution.error;
    }
}

void sizes(benchmark::internal::Benchmark* measured) {
    measured->ArgName("about")->Arg(5000)->Arg(10000)->Arg(20000)->Arg(50000)->Arg(100000);
    measured->Unit(benchmark::kMillisecond)->UseRealTime();
}

}  // namespace

BENCHMARK(radiosities)->Name("engine radiosities")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(links, engine links threshold 1e-3, false)->Apply(sizes);
BENCHMARK_CAPTURE(links, engine links threshold 5 by patches, true)->Apply(sizes);
BENCHMARK(toError)->Name("engine Cornell to 1 percent, file to picture")->Unit(benchmark::kMillisecond)->UseRealTime();
