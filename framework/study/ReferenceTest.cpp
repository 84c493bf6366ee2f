#include "study/Reference.h"

#include <cmath>
#include <map>

#include <doctest/doctest.h>

#include "engine/FormFactors.h"
#include "engine/PathTracer.h"
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
    CHECK(relativeError({1, 1}, found, truth) == Approx(std::sqrt(5.0 / 25.0)));
    CHECK(relativeError({4, 1}, found, truth) == Approx(std::sqrt(8.0 / 52.0)));
    CHECK(relativeError({1, 1}, truth, truth) == 0.0);
    CHECK(relativeError({1, 1}, {Point(0.0), Point(0.0)}, {Point(0.0), Point(0.0)}) == 0.0);
}

TEST_CASE("every fine patch lies in its coarse one, on the same face, and together they fill it") {
    for (const char* name : {"cornell_2", "grey_room"}) {
        const std::string which = name;
        CAPTURE(which);
        const Scene scene = read(name);
        const StudyMesh coarse(scene, patchSizeFor(scene, 200));
        const FineMesh fine(coarse, 3);
        std::vector<double> areas(coarse.geometry.patches.size());
        for (std::size_t i = 0; i < fine.geometry.patches.size(); ++i) {
            const auto in = static_cast<std::size_t>(fine.mesh.faceOf[i]);
            const engine::Polygon &small = fine.geometry.patches[i], &large = coarse.geometry.patches[in];
            areas[in] += small.area;
            REQUIRE(fine.geometry.faceOf[i] == coarse.geometry.faceOf[in]);
            REQUIRE(fine.surfaces.reflectance[i] == coarse.surfaces.reflectance[in]);
            REQUIRE(fine.surfaces.emission[i] == coarse.surfaces.emission[in]);
            REQUIRE(glm::distance(small.center, large.center) <= large.radius * (1 + 1e-5));
        }
        for (std::size_t i = 0; i < areas.size(); ++i)
            REQUIRE(areas[i] == Approx(coarse.geometry.patches[i].area).epsilon(1e-5));
        CHECK(fine.geometry.patches.size() > 6 * areas.size());
    }
}

TEST_CASE("the solver's reference agrees with independent paths within its estimated error and theirs") {
    const Scene scene = read("grey_room");
    const StudyMesh mesh(scene, patchSizeFor(scene, 120));
    const SolverReference reference = solverReference(mesh, 512);
    CHECK(reference.error < 1e-3);
    engine::PathRadiosityOptions options;
    options.samples = 2048;
    options.constantPatches = true;
    const auto paths = engine::pathTraceRadiosity(mesh.traced(), options);
    const std::vector<double> areas = areasOf(mesh.geometry);
    std::vector<Point> off = reference.radiosity;
    for (std::size_t i = 0; i < off.size(); ++i) off[i] += paths.standardError[i];
    const double expected = relativeError(areas, off, reference.radiosity);
    CHECK(relativeError(areas, paths.radiosity, reference.radiosity) < 2.0 * std::hypot(expected, reference.error));
}

TEST_CASE("in the furnace, where all patches shine alike, nothing is lost by the mesh") {
    const Scene scene = read("furnace");
    const StudyMesh mesh(scene, patchSizeFor(scene, 60));
    const WholeReference light(mesh, 1000, 1e-6);
    const SolverReference reference = solverReference(mesh, 64);
    CHECK(light.errorOf(reference.radiosity) < 2e-3);
    std::vector<Point> brighter = reference.radiosity;
    for (Point& radiosity : brighter) radiosity *= 1.1;
    CHECK(light.errorOf(brighter) == Approx(0.1).epsilon(0.02));
}

TEST_CASE("the whole error does not depend on how fine the mesh is that it is measured by") {
    const Scene scene = read("cornell_1");
    const StudyMesh mesh(scene, patchSizeFor(scene, 150));
    const std::vector<Point> radiosity = solverReference(mesh, 64).radiosity;
    const WholeReference fair(mesh, 700, 1e-5), fine(mesh, 4000, 1e-5);
    REQUIRE(fine.patches() > 4 * fair.patches());
    CHECK(fine.meshError() < 0.6 * fair.meshError());
    CHECK(fair.errorOf(radiosity) == Approx(fine.errorOf(radiosity)).epsilon(0.15));
}
