#include <cmath>

#include <doctest/doctest.h>

#include "course/Extensions.h"
#include "course/PatchMesh.h"
#include "course/TestMeshes.h"

using namespace radlab;

namespace {

// The middle of a square of edge 2 looks at one as large, right above it.
double centreToFacingSquare(double distance) {
    const double a = 1.0 / std::sqrt(1.0 + distance * distance);
    return 4.0 * a * std::atan(a) / std::acos(-1.0);
}

// A shooter in z = 0, 2 x 2, and one as large at that height which looks down.
std::unique_ptr<PatchMesh> twoSquares(float distance) {
    test::Faces faces;
    faces.add({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, test::material(Vec3f(0.5f), Vec3f(1.0f)));
    faces.add({{-1, -1, distance}, {-1, 1, distance}, {1, 1, distance}, {1, -1, distance}});
    std::unique_ptr<PatchMesh> mesh = faces.mesh(3.0f);
    mesh->reset();
    mesh->publish();
    return mesh;
}

}  // namespace

TEST_CASE("rays over the hemisphere: facing squares match the closed form within five standard errors, ever closer") {
    for (const float distance : {0.2f, 1.0f, 4.0f}) {
        const auto mesh = twoSquares(distance);
        const RayCaster scene(polygons, vertices);
        const double exact = centreToFacingSquare(static_cast<double>(distance));
        for (const int rays : {100, 10000, 1000000}) {
            CAPTURE(distance);
            CAPTURE(rays);
            RandomNumbers random(1);
            CHECK(hemisphereFF(scene, rays, random) == polygons[0]);
            const double error = std::sqrt(exact * (1.0 - exact) / rays);
            CHECK(std::abs(static_cast<double>(polygons[1]->formF) - exact) < 5.0 * error);
            CHECK(polygons[0]->formF == 0.0f);
        }
    }
}

TEST_CASE("rays over the hemisphere: the mean square error is the variance of a share, F(1-F)/rays") {
    const auto mesh = twoSquares(1.0f);
    const RayCaster scene(polygons, vertices);
    const double exact = centreToFacingSquare(1.0);
    for (const int rays : {10, 1000}) {
        RandomNumbers random(3);
        const int shots = 2000;
        double sum = 0.0;
        for (int i = 0; i < shots; ++i) {
            hemisphereFF(scene, rays, random);
            sum += std::pow(static_cast<double>(polygons[1]->formF) - exact, 2);
        }
        CHECK(sum / shots == doctest::Approx(exact * (1.0 - exact) / rays).epsilon(0.15));
    }
}

TEST_CASE("rays over the hemisphere: in a closed room the form factors sum to 1") {
    test::Faces room;
    room.addRoom(Vec3f(0.0f), Vec3f(2.0f, 3.0f, 1.0f), test::material(Vec3f(0.5f), Vec3f(1.0f)));
    const auto mesh = room.mesh(0.4f);
    mesh->reset();
    mesh->publish();
    const RayCaster scene(polygons, vertices);
    RandomNumbers random(5);
    for (int shot = 0; shot < 20; ++shot) {
        MyPolygon* shooter = hemisphereFF(scene, 1000, random);
        float sum = 0.0f;
        for (const MyPolygon* patch : polygons) sum += patch->formF;
        CHECK(sum == doctest::Approx(1.0).epsilon(1e-5));
        shooter->unshot_rad = Vec3f(0.0f);
    }
}

TEST_CASE("rays over the hemisphere: without patches there is no shooter") {
    PatchMesh mesh;
    mesh.publish();
    RandomNumbers random(1);
    CHECK(hemisphereFF(RayCaster(polygons, vertices), 10, random) == nullptr);
}
