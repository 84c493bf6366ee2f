#include "engine/Cost.h"

#include <doctest/doctest.h>

#include "engine/SpecularTransport.h"
#include "scene/X3dReader.h"

using namespace radlab;
using namespace radlab::engine;
using doctest::Approx;

namespace {

Scene read(const char* name) { return readX3d(std::string(RADLAB_SOURCE_DIR "/resources/scenes/") + name + ".x3d"); }

Geometry cut(const Scene& scene, float patchSize) {
    return geometryOf(scene, PatchMesh(scene.vertices, scene.faces, patchSize, patchSize));
}

FormFactorOptions with(Method method, double tolerance = 1e-6, std::size_t rays = 0) {
    FormFactorOptions options;
    options.method = method;
    options.tolerance = tolerance;
    options.rays = rays;
    return options;
}

Cost costOfScene(const char* name, float patchSize, const FormFactorOptions& options = {}) {
    const Scene scene = read(name);
    return expectedCost(workOf(scene, cut(scene, patchSize), options), findEffects(scene));
}

}  // namespace

TEST_CASE("all pairs of a cube's faces face each other, and touch or nearly so") {
    const Scene scene = read("furnace");
    const Work work = workOf(scene, geometryOf(scene), {});
    CHECK(work.patches == 6);
    CHECK(work.facing == 15.0);
    CHECK(work.touching == 15.0);
    CHECK(work.raysPerPair == 0.0);
}

TEST_CASE("pairs of one wall do not face each other, and those far apart do not touch") {
    const Scene scene = read("furnace");
    const Geometry geometry = cut(scene, 0.25f);
    const Work work = workOf(scene, geometry, {});
    CHECK(work.patches == 96);
    CHECK(work.facing == 96 * 80 / 2);
    CHECK(work.touching < 0.2 * work.facing);
    CHECK(work.touching > 96);
}

TEST_CASE("the pairs of a fine mesh are counted by some of them, nearly right") {
    const Scene scene = read("furnace");
    const Geometry geometry = cut(scene, 1.0f / 24.0f);
    const Work work = workOf(scene, geometry, {});
    CHECK(work.patches == 3456);
    CHECK(work.facing == Approx(3456.0 * 5.0 * 576.0 / 2.0).epsilon(1e-9));
    CHECK(work.facing == workOf(scene, geometry, {}).facing);
}

TEST_CASE("occlusion costs rays where there is something to hide behind") {
    const Scene scene = read("cornell_2");
    const Work work = workOf(scene, cut(scene, 80.0f), {});
    CHECK(work.raysPerPair > 1.0);
    CHECK(work.raysPerPair <= 64.0);
    Effects effects = findEffects(scene);
    const double withRays = expectedCost(work, effects).formFactors;
    CHECK(costOf(Effect::occlusion, work, effects) > 0.5 * withRays);
    effects[Effect::occlusion].on = false;
    CHECK(expectedCost(work, effects).formFactors + costOf(Effect::occlusion, work, effects) == Approx(withRays));
}

TEST_CASE("a finer mesh, a finer tolerance and more rays cost more") {
    const double coarse = costOfScene("cornell_1", 100.0f, with(Method::exact)).formFactors;
    CHECK(costOfScene("cornell_1", 50.0f, with(Method::exact)).formFactors > 4.0 * coarse);
    double last = 0.0;
    for (const double tolerance : {0.1, 1e-2, 1e-3, 1e-5, 1e-6, 1e-8, 1e-12}) {
        CAPTURE(tolerance);
        const double now = costOfScene("cornell_1", 100.0f, with(Method::exact, tolerance)).formFactors;
        CHECK(now >= last);
        last = now;
    }
    const double few = costOfScene("cornell_1", 100.0f, with(Method::hemisphere, 1e-6, 100)).formFactors;
    CHECK(costOfScene("cornell_1", 100.0f, with(Method::hemisphere, 1e-6, 300)).formFactors == Approx(3.0 * few));
    CHECK(costOfScene("cornell_1", 100.0f, with(Method::point)).formFactors <
          costOfScene("cornell_1", 100.0f, with(Method::polygon)).formFactors);
}

TEST_CASE("each channel, each bounce, each mirror and each smooth edge has its price") {
    const Scene scene = read("mirror");
    const Work work = workOf(scene, cut(scene, 80.0f), {});
    const Effects effects = findEffects(scene);
    for (const Effect effect : {Effect::indirect, Effect::colour, Effect::specular, Effect::antialias, Effect::smooth})
        CHECK(costOf(effect, work, effects) > 0.0);
    CHECK(costOf(Effect::transparency, work, effects) == 0.0);
}

TEST_CASE("light over specular faces costs its rays, where it belongs to the solution") {
    const Scene scene = read("mirror");
    const Geometry geometry = cut(scene, 80.0f);
    const Work work = workOf(scene, geometry, {});
    const std::size_t rays = SpecularOptions().rays, patches = geometry.patches.size();
    CHECK(work.specularRays > 0.5 * static_cast<double>(rays * patches));
    CHECK(work.specularRays <= 2.0 * static_cast<double>(rays * patches));
    Effects effects = findEffects(scene);
    const Cost with = expectedCost(work, effects);
    CHECK(with.specular > 0.0);
    CHECK(costOf(Effect::specular, work, effects) > with.specular);
    effects[Effect::specular].on = false;
    CHECK(expectedCost(work, effects).specular == 0.0);
    CHECK(costOfScene("cornell_2", 80.0f).specular == 0.0);
}

TEST_CASE("the stored matrix is most of the memory of a fine mesh, and no patches cost no form factors") {
    const double bytes = costOfScene("furnace", 1.0f / 24.0f).bytes;
    CHECK(bytes > 8.0 * 3456.0 * 3456.0);
    CHECK(bytes < 1.5 * 8.0 * 3456.0 * 3456.0);
    const Scene empty;
    const Cost cost = expectedCost(workOf(empty, geometryOf(empty), {}), findEffects(empty));
    CHECK(cost.formFactors == 0.0);
    CHECK(cost.radiosities == 0.0);
}
