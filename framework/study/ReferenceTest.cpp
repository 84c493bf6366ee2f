#include "study/Reference.h"

#include <cmath>
#include <map>

#include <doctest/doctest.h>

#include "engine/FormFactors.h"
#include "engine/PathTracer.h"
#include "engine/RelativeError.h"
#include "scene/X3dReader.h"

using namespace radlab;
using namespace radlab::study;
using doctest::Approx;
using engine::Point;

namespace {

Scene read(const std::string& name) { return readX3d(RADLAB_SOURCE_DIR "/resources/scenes/" + name + ".x3d"); }

}  // namespace

TEST_CASE("the relative error is the RMS of what is off over the RMS of the truth, by area and over all channels") {
    const std::vector<Point> truth = {{3, 0, 0}, {0, 4, 0}}, found = {{3, 0, 1}, {0, 2, 0}};
    CHECK(engine::relativeError({1, 1}, found, truth) == Approx(std::sqrt(5.0 / 25.0)));
    CHECK(engine::relativeError({4, 1}, found, truth) == Approx(std::sqrt(8.0 / 52.0)));
    CHECK(engine::relativeError({1, 1}, truth, truth) == 0.0);
    CHECK(engine::relativeError({1, 1}, {Point(0.0), Point(0.0)}, {Point(0.0), Point(0.0)}) == 0.0);
}

TEST_CASE("the solver's reference agrees with independent paths within its estimated error and theirs") {
    const Scene scene = read("grey_room");
    const StudyMesh mesh(scene, engine::patchSizeFor(scene, 120));
    const SolverReference reference = solverReference(mesh, 512);
    CHECK(reference.error < 1e-3);
    engine::PathRadiosityOptions options;
    options.samples = 2048;
    options.constantPatches = true;
    const auto paths = engine::pathTraceRadiosity(mesh.traced(), options);
    const std::vector<double> areas = areasOf(mesh.geometry);
    std::vector<Point> off = reference.radiosity;
    for (std::size_t i = 0; i < off.size(); ++i) off[i] += paths.standardError[i];
    const double expected = engine::relativeError(areas, off, reference.radiosity);
    CHECK(engine::relativeError(areas, paths.radiosity, reference.radiosity) <
          2.0 * std::hypot(expected, reference.error));
}

TEST_CASE("in the furnace, where all patches shine alike, nothing is lost by the mesh") {
    const Scene scene = read("furnace");
    const StudyMesh mesh(scene, engine::patchSizeFor(scene, 60));
    const WholeReference light(mesh, 1000, 1e-6);
    const SolverReference reference = solverReference(mesh, 64);
    CHECK(light.errorOf(reference.radiosity) < 2e-3);
    std::vector<Point> brighter = reference.radiosity;
    for (Point& radiosity : brighter) radiosity *= 1.1;
    CHECK(light.errorOf(brighter) == Approx(0.1).epsilon(0.02));
}

TEST_CASE("the whole error does not depend on how fine the mesh is that it is measured by") {
    const Scene scene = read("cornell_1");
    const StudyMesh mesh(scene, engine::patchSizeFor(scene, 150));
    const std::vector<Point> radiosity = solverReference(mesh, 64).radiosity;
    const WholeReference fair(mesh, 700, 1e-5), fine(mesh, 4000, 1e-5);
    REQUIRE(fine.patches() > 4 * fair.patches());
    CHECK(fine.meshError() < 0.6 * fair.meshError());
    CHECK(fair.errorOf(radiosity) == Approx(fine.errorOf(radiosity)).epsilon(0.15));
}
