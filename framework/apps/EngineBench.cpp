// How fast the engine finds form factors and radiosities.

#include <memory>

#include <benchmark/benchmark.h>

#include "engine/FormFactors.h"
#include "engine/Radiosity.h"
#include "scene/X3dReader.h"

namespace {

using namespace radlab;
using namespace radlab::engine;

struct Setting {
    Setting(const char* scene, float patchSize)
        : Setting(readX3d(std::string(RADLAB_SOURCE_DIR "/resources/scenes/") + scene), patchSize) {}
    Setting(const Scene& scene, float size)
        : mesh(scene.vertices, scene.faces, size, size), geometry(geometryOf(scene, mesh)) {}

    PatchMesh mesh;
    Geometry geometry;
};

void matrices(benchmark::State& state, const char* scene, float patchSize, const FormFactorOptions& options) {
    const Setting setting(scene, patchSize);
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

void radiosities(benchmark::State& state) {
    const Setting setting("cornell_2.x3d", 20.0f);
    const FormFactorMatrix matrix = formFactors(setting.geometry, with(Method::exact, 1e-4));
    Surfaces surfaces = surfacesOf(setting.mesh);
    for (Point& reflectance : surfaces.reflectance)
        reflectance *= 0.5;  // what hides others is left out, so rows exceed 1
    SolverOptions options;
    options.tolerance = 1e-6;
    for (auto _ : state) benchmark::DoNotOptimize(solveRadiosity(matrix, surfaces, options));
    state.counters["patches"] = static_cast<double>(setting.geometry.patches.size());
}

}  // namespace

BENCHMARK_CAPTURE(matrices, engine exact 1e-4 box, "furnace.x3d", 0.0334f, with(Method::exact, 1e-4))
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(matrices, engine exact 1e-6 box, "furnace.x3d", 0.0334f, with(Method::exact, 1e-6))
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(matrices, engine exact 1e-12 box, "furnace.x3d", 0.0334f, with(Method::exact, 1e-12))
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(matrices, engine visibility Cornell, "cornell_2.x3d", 45.0f, with(Method::visibility, 1e-4, 16))
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(matrices, engine hemisphere Cornell, "cornell_2.x3d", 45.0f, with(Method::hemisphere, 1e-4))
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(radiosities)->Name("engine radiosities")->Unit(benchmark::kMillisecond)->UseRealTime();
