// Energy in closed scenes, with any right solution; compiled with each one that is here.

#include <doctest/doctest.h>

#include "TestPatches.h"
#include "course/ProgRef.h"
#include "gl/Context.h"
#include "solver/Progressive.h"

using namespace radlab;
using namespace radlab::test;
using doctest::Approx;

namespace {

const Vec3f low(0.0f), high(1.0f);

// A unit cube of six colours, one wall of it also shining, in bluish light.
Faces colouredCube() {
    Faces faces;
    faces.addRoom(low, high, material(Vec3f(0.5f)));
    const Vec3f colours[] = {{0.2f, 0.5f, 0.8f},  {0.3f, 0.3f, 0.3f}, {0.9f, 0.1f, 0.05f},
                             {0.05f, 0.9f, 0.1f}, {0.7f, 0.7f, 0.7f}, {0.5f, 0.4f, 0.95f}};
    for (std::size_t i = 0; i < 6; ++i)
        faces.faces[i].material = material(colours[i], i == 1 ? Vec3f(1, 2, 4) : Vec3f(0.0f));
    return faces;
}

// A room with a block that hangs in it and shines at its top.
Faces roomWithBlock() {
    Faces faces;
    faces.addRoom(low, high, material(Vec3f(0.8f, 0.6f, 0.4f)));
    Faces block;
    block.addRoom(Vec3f(0.3f, 0.3f, 0.25f), Vec3f(0.6f, 0.7f, 0.65f), material(Vec3f(0.3f, 0.5f, 0.7f)));
    for (std::size_t i = 0; i < block.faces.size(); ++i) {
        std::vector<Vec3f> corners;
        for (const int corner : block.faces[i].corners) corners.insert(corners.begin(), block.positions[corner]);
        faces.add(corners, material(Vec3f(0.3f, 0.5f, 0.7f), i == 1 ? Vec3f(5, 3, 1) : Vec3f(0.0f)));
    }
    return faces;
}

glm::dvec3 sum(const PatchMesh& mesh, glm::dvec3 (*power)(const MyPolygon&)) {
    glm::dvec3 total(0.0);
    for (const MyPolygon& patch : mesh.patches) total += double(patch.area) * power(patch);
    return total;
}

// Per channel: what the patches say they have taken in, from B = E + ρH.
glm::dvec3 absorbed(const PatchMesh& mesh) {
    return sum(mesh, [](const MyPolygon& patch) {
        const glm::dvec3 reflectance(patch.diffuse);
        return (1.0 - reflectance) * (glm::dvec3(patch.rad) - glm::dvec3(patch.emissive)) / reflectance;
    });
}

// After every shot: nothing of what was emitted is lost or made, in each channel and in the solver's own account.
void checkEnergy(const Faces& faces, float patchSize, int shots) {
    const auto context = GlContext::offscreen();
    Hemicube hemicube(256);
    const auto mesh = faces.mesh(patchSize);
    Progressive solver(*mesh, [&] { return calcFF(&hemicube); });
    const glm::dvec3 emitted = sum(*mesh, [](const MyPolygon& patch) { return glm::dvec3(patch.emissive); });
    double worst = 0.0;
    const auto check = [&](const Progress& progress) {
        const glm::dvec3 found =
            absorbed(*mesh) + sum(*mesh, [](const MyPolygon& patch) { return glm::dvec3(patch.unshot_rad); });
        for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(found[c] / emitted[c] - 1.0));
        worst = std::max(worst, std::abs((progress.absorbed + progress.unshot) / progress.emitted - 1.0));
        return true;
    };
    solver.run({shots, 1e-3}, check);
    MESSAGE(mesh->patches.size() << " patches, " << solver.progress().shots << " shots, unshot "
                                 << solver.progress().unshotShare << ", lost at worst " << worst);
    CHECK(worst < 0.01);
    CHECK(solver.progress().unshotShare < 0.1);
    CHECK(solver.progress().emitted == Approx(emitted.x + emitted.y + emitted.z).epsilon(1e-6));
}

}  // namespace

TEST_CASE("in a coloured cube emitted = absorbed + unshot within 1 % after every shot, in each channel") {
    checkEnergy(colouredCube(), 0.25f, 400);
}

TEST_CASE("in a room with a block emitted = absorbed + unshot within 1 % after every shot, in each channel") {
    checkEnergy(roomWithBlock(), 0.25f, 400);
}
