// How fast the engine finds form factors.

#include <benchmark/benchmark.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include "apps/EngineBench.h"
#include "engine/FormFactors.h"
#include "engine/Hemicubes.h"

namespace {

using namespace radlab;
using namespace radlab::engine;

void matrices(benchmark::State& state, const char* scene, double patches, const FormFactorOptions& options) {
    const Setting setting(scene, patches);
    for (auto _ : state) {
        const FormFactorMatrix matrix = formFactors(setting.geometry, options);
        benchmark::DoNotOptimize(matrix.row(0));
    }
    state.counters["patches"] = static_cast<double>(setting.geometry.patches.size());
}

FormFactorOptions with(Method method, double tolerance, std::size_t rays = 0) {
    FormFactorOptions options;
    options.method = method;
    options.tolerance = tolerance;
    options.rays = rays;
    return options;
}

// A batch of rows, from patches all over the scene.
void hemicubeRows(benchmark::State& state, std::size_t threads) {
    constexpr std::size_t batch = 64;
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const Setting setting("cornell_2.x3d", static_cast<double>(state.range(0)));
    const std::size_t count = setting.geometry.patches.size();
    const Hemicubes hemicubes(setting.geometry.patches, static_cast<int>(state.range(1)));
    std::vector<double> rows(batch * count);
    std::size_t next = 0;
    for (auto _ : state) {
        tbb::parallel_for(std::size_t{0}, batch,
                          [&](std::size_t i) { hemicubes.row((next + 101 * i) % count, &rows[i * count]); });
        next += 101 * batch;
        benchmark::DoNotOptimize(rows.data());
    }
    state.counters["patches"] = static_cast<double>(count);
    state.counters["hemicubes/s"] =
        benchmark::Counter(static_cast<double>(state.iterations() * batch), benchmark::Counter::kIsRate);
}

void hemicubeSizes(benchmark::internal::Benchmark* measured) {
    measured->ArgNames({"about", "size"})->Args({5000, 64})->Args({5000, 256})->Args({5000, 512})->Args({20000, 256});
    measured->Unit(benchmark::kMillisecond)->UseRealTime();
}

}  // namespace

BENCHMARK_CAPTURE(matrices, engine exact 1e-4 box, "furnace.x3d", 5400, with(Method::exact, 1e-4))
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(matrices, engine exact 1e-6 box, "furnace.x3d", 5400, with(Method::exact, 1e-6))
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(matrices, engine exact 1e-12 box, "furnace.x3d", 5400, with(Method::exact, 1e-12))
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(matrices, engine visibility Cornell, "cornell_2.x3d", 1000, with(Method::visibility, 1e-4, 16))
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(matrices, engine hemisphere Cornell, "cornell_2.x3d", 1000, with(Method::hemisphere, 1e-4))
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(hemicubeRows, engine hemicubes, std::size_t{1} << 16)->Apply(hemicubeSizes);
BENCHMARK_CAPTURE(hemicubeRows, engine hemicubes one thread, 1)->Apply(hemicubeSizes);
