#include "engine/SolveToError.h"

#include <doctest/doctest.h>

#include "engine/HierarchicalRadiosity.h"
#include "engine/RelativeError.h"
#include "engine/SpecularTransport.h"
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
    const std::vector<Scattering> scatterings = scatteringsOf(scene);
    Subdivision fine = subdivide(scene, *solution.mesh, solution.patchSize, 3);
    fine.geometry.through = throughOf(scatterings);
    SpecularOptions rays;
    rays.rays = 512;
    rays.seed = 2;
    const SpecularTransport specular(fine.geometry, scatterings, rays);
    HierarchicalOptions options;
    options.threshold = 1e-5;
    options.further = specular.further();
    options.occlusion = findEffects(scene).has(Effect::occlusion);
    return relativeError(solution.radiosity, fine, solveHierarchical(fine.geometry, fine.surfaces, options));
}

// The Cornell box with its short block of glass, which lets most light through and mirrors some.
Scene withGlass(double specular) {
    Scene scene = sceneNamed("cornell_2.x3d");
    const auto glass = std::make_shared<Material>();
    glass->transparency = 0.7f;
    glass->specular = Vec3f(static_cast<float>(specular));
    glass->shininess = 1.0f;
    for (std::size_t face = scene.faces.size() - 10; face < scene.faces.size() - 5; ++face)
        scene.faces[face].material = glass;
    return scene;
}

void checkErrors(const Scene& scene) {
    for (const double error : {0.1, 0.04}) {
        CAPTURE(error);
        const AccurateSolution solution = solvedTo(scene, error);
        CHECK(solution.reached);
        CHECK(solution.error <= error);
        CHECK(trueError(scene, solution) <= error);
    }
}

}  // namespace

TEST_CASE("the true error is at most the one asked for") {
    for (const char* file : {"cornell_1.x3d", "cornell_2.x3d", "l_room.x3d", "grey_room.x3d", "plates.x3d"}) {
        CAPTURE(file);
        checkErrors(sceneNamed(file));
    }
}

TEST_CASE("the true error is at most the one asked for with a mirror, too") { checkErrors(sceneNamed("mirror.x3d")); }

TEST_CASE("the true error is at most the one asked for with glass that mirrors, too") { checkErrors(withGlass(0.5)); }

// Errors of the table are those of more patches, where the errors of rays average out further.
TEST_CASE("where faces let light through, ways do, too, and err by three times what they promise at most, or 0.3 %") {
    const Scene scene = withGlass(0.0);
    const Effects effects = findEffects(scene);
    const std::vector<Scattering> scatterings = scatteringsOf(scene);
    const PatchMesh mesh(scene.vertices, scene.faces, 150.0f, 150.0f);
    Geometry geometry = geometryOf(scene, mesh);
    geometry.through = throughOf(scatterings);
    const Surfaces surfaces = surfacesOf(mesh, scatterings);
    FormFactorOptions options;
    options.rays = 256;
    const std::vector<Point> truth = solveRadiosity(formFactors(geometry, options), surfaces);
    for (const Way& way : waysFor(workOf(scene, geometry, {}), effects)) {
        CAPTURE(describe(way));
        CHECK(way.method != Method::hemicube);
        const std::vector<Point> found = solveBy(way, geometry, surfaces, scatterings, effects);
        CHECK(relativeError(areasOf(geometry), found, truth) < 3.0 * std::max(way.error, 1e-3));
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
