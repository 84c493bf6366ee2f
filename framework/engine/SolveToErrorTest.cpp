#include "engine/SolveToError.h"

#include <doctest/doctest.h>

#include "engine/HierarchicalRadiosity.h"
#include "engine/RelativeError.h"
#include "engine/Subdivision.h"
#include "scene/X3dReader.h"

using namespace radlab;
using namespace radlab::engine;
using doctest::Approx;

namespace {

Scene sceneNamed(const std::string& file) { return readX3d(RADLAB_SOURCE_DIR "/resources/scenes/" + file); }

AccurateSolution solvedTo(const Scene& scene, double error, double patchSize = 0.0) {
    ErrorGoal goal;
    goal.error = error;
    goal.patchSize = patchSize;
    return solveToError(scene, findEffects(scene), goal);
}

double trueError(const Scene& scene, const AccurateSolution& solution) {
    const Subdivision fine = subdivide(scene, *solution.mesh, solution.patchSize, 3);
    HierarchicalOptions options;
    options.threshold = 1e-5;
    options.occlusion = findEffects(scene).has(Effect::occlusion);
    return relativeError(solution.radiosity, fine, solveHierarchical(fine.geometry, fine.surfaces, options));
}

}  // namespace

TEST_CASE("the true error is at most the one asked for") {
    for (const char* file : {"cornell_1.x3d", "cornell_2.x3d", "l_room.x3d", "grey_room.x3d", "plates.x3d"})
        for (const double error : {0.1, 0.04}) {
            CAPTURE(file);
            CAPTURE(error);
            const Scene scene = sceneNamed(file);
            const AccurateSolution solution = solvedTo(scene, error);
            CHECK(solution.reached);
            CHECK(solution.error <= error);
            CHECK(trueError(scene, solution) <= error);
        }
}

TEST_CASE("where the patches are given, the error asked for is that of the solution on them") {
    const Scene scene = sceneNamed("cornell_2.x3d");
    for (const double error : {1e-2, 2e-3}) {
        CAPTURE(error);
        const AccurateSolution solution = solvedTo(scene, error, 60.0);
        CHECK(solution.patchSize == 60.0);
        CHECK(solution.reached);
        FormFactorOptions options;
        options.rays = 256;
        const std::vector<Point> truth = solveRadiosity(formFactors(solution.geometry, options), solution.surfaces);
        CHECK(relativeError(areasOf(solution.geometry), solution.radiosity, truth) <= error);
    }
}

TEST_CASE("a smaller error takes a finer mesh, and a dark scene takes the coarsest") {
    const Scene scene = sceneNamed("cornell_1.x3d");
    CHECK(solvedTo(scene, 0.1).geometry.patches.size() < solvedTo(scene, 0.01).geometry.patches.size());
    const AccurateSolution dark = solvedTo(sceneNamed("dark.x3d"), 0.01);
    CHECK(dark.reached);
    CHECK(dark.error == 0.0);
}

TEST_CASE("the cheapest way is the fastest of those that are accurate enough, else the most accurate") {
    std::vector<Way> ways(3);
    ways[0].error = 0.1;
    ways[0].seconds = 1.0;
    ways[1].error = 0.01;
    ways[1].seconds = 3.0;
    ways[2].error = 0.001;
    ways[2].seconds = 2.0;
    CHECK(cheapestWay(ways, 0.2).error == 0.1);
    CHECK(cheapestWay(ways, 0.05).error == 0.001);
    CHECK(cheapestWay(ways, 0.2, 3.0).error == 0.001);
    CHECK(cheapestWay(ways, 1e-6).error == 0.001);
}

TEST_CASE("every patch of a subdivision lies in its coarse patch, and all add up to it") {
    const Scene scene = sceneNamed("l_room.x3d");
    const PatchMesh mesh(scene.vertices, scene.faces, 0.7f, 0.7f);
    const Subdivision fine = subdivide(scene, mesh, 0.7, 2);
    std::vector<double> area(mesh.patches.size());
    for (std::size_t i = 0; i < fine.coarseOf.size(); ++i) {
        area[fine.coarseOf[i]] += fine.geometry.patches[i].area;
        CHECK(fine.geometry.faceOf[i] == std::size_t(mesh.faceOf[fine.coarseOf[i]]));
        CHECK(fine.surfaces.emission[i] == Point(mesh.patches[fine.coarseOf[i]].emissive));
    }
    for (std::size_t i = 0; i < area.size(); ++i) CHECK(area[i] == Approx(double(mesh.patches[i].area)).epsilon(1e-5));
    CHECK(fine.coarseOf.size() > 2 * area.size());
}
