#include <doctest/doctest.h>

#include "TestPatches.h"
#include "course/ProgRef.h"
#include "solver/Progressive.h"

using namespace radlab;
using namespace radlab::test;

TEST_CASE("the older rule picks the patch with the most unshot radiosity, whatever its area") {
    const auto mesh = scattered(3, 1);
    for (MyPolygon* patch : polygons) patch->unshot_rad = Vec3f(1.0f);
    polygons[1]->unshot_rad = Vec3f(1.1f);
    polygons[1]->area = 0.01f;
    polygons[2]->area = 100.0f;
    CHECK(maxenergy_patch() == polygons[1]);
}

TEST_CASE("the older rule comes to the same light, where areas differ tenfold") {
    Faces faces;
    faces.addRoom(Vec3f(0), Vec3f(1), material(Vec3f(0.5f)));
    faces.faces[1].material = material(Vec3f(0.5f), Vec3f(1.0f));
    PatchMesh mesh(faces.positions, faces.faces, 0.5f, 0.16f);
    // Any row that sums to 1 gives the emitted power over 1 - ρ in all, whatever the order of the shots.
    Progressive solver(mesh, [&mesh] {
        MyPolygon* shooter = maxenergy_patch();
        float area = 0.0f;
        for (const MyPolygon& patch : mesh.patches) area += &patch == shooter ? 0.0f : patch.area;
        for (MyPolygon& patch : mesh.patches) patch.formF = &patch == shooter ? 0.0f : patch.area / area;
        return shooter;
    });
    solver.run({100000, 1e-5});
    double power = 0.0;
    for (const MyPolygon& patch : mesh.patches) power += double(patch.rad.g) * double(patch.area);
    CHECK(solver.progress().unshotShare <= 1e-5);
    CHECK(power == doctest::Approx(1.0 / (1.0 - 0.5)).epsilon(1e-4));
}
