// What the scenes of resources/scenes promise.

#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>

#include <doctest/doctest.h>

#include "base/Warning.h"
#include "course/ProgRef.h"
#include "gl/Context.h"
#include "scene/Effects.h"
#include "scene/X3dReader.h"
#include "solver/FormFactors.h"

using namespace radlab;
using doctest::Approx;

namespace {

struct Expected {
    float patchSize;
    bool closed;     // nothing escapes
    bool occlusion;  // something hides something
};

const std::map<std::string, Expected> scenes = {
    {"cornell_1", {80, false, false}}, {"cornell_2", {80, false, true}},  {"dark", {0.25f, true, false}},
    {"furnace", {0.25f, true, false}}, {"grey_room", {0.5f, true, true}}, {"l_room", {0.7f, true, true}},
    {"mirror", {80, false, true}},     {"plates", {0.25f, false, false}}, {"teapot", {2, true, true}},
};

Scene read(const std::string& name) { return readX3d(RADLAB_SOURCE_DIR "/resources/scenes/" + name + ".x3d"); }

PatchMesh meshed(const Scene& scene, float size) { return {scene.vertices, scene.faces, size, size}; }

double area(const PatchMesh& mesh) {
    double sum = 0.0;
    for (const MyPolygon& patch : mesh.patches) sum += double(patch.area);
    return sum;
}

// Area-weighted mean radiosity, channels added up, of a scene solved by a method.
double meanRadiosity(const Scene& scene, float size, FormFactorMethod method) {
    const auto context = GlContext::offscreen();
    PatchMesh mesh = meshed(scene, size);
    Progressive solver(mesh, formFactorsBy(method, 128));
    Limits limits;
    limits.unshotShare = 0.01;
    solver.run(limits);
    double sum = 0.0;
    for (const MyPolygon& patch : mesh.patches)
        sum += double(patch.area) * double(patch.rad.r + patch.rad.g + patch.rad.b);
    return sum / area(mesh);
}

}  // namespace

TEST_CASE("every scene is read without a warning and becomes patches, each with a camera and a comment") {
    std::set<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(RADLAB_SOURCE_DIR "/resources/scenes")) {
        if (entry.path().extension() != ".x3d") continue;
        const std::string name = entry.path().stem().string();
        CAPTURE(name);
        found.insert(name);
        REQUIRE(scenes.count(name) == 1);
        WarningCapture warnings;
        const Scene scene = read(name);
        CHECK(scene.cameras.size() == 1);
        CHECK(meshed(scene, scenes.at(name).patchSize).patches.size() > 1);
        CHECK(warnings.texts.empty());
    }
    CHECK(found.size() == scenes.size());
}

TEST_CASE("the settings files that are here can be read, and name scenes that are here") {
    for (const char* name : {"Resource.xml", "demo/empty.xml", "demo/furnished.xml"}) {
        CAPTURE(name);
        const Resource resource = readResource(std::string(RADLAB_SOURCE_DIR "/resources/") + name);
        CHECK(scenes.count(resource.sceneFile.stem().string()) == 1);
    }
}

TEST_CASE("occlusion is found in the scenes that have it") {
    for (const auto& [name, expected] : scenes) {
        const std::string which = name;
        CAPTURE(which);
        CHECK(findEffects(read(name)).has(Effect::occlusion) == expected.occlusion);
    }
}

TEST_CASE("auto takes the formula where nothing hides anything, the hemicube elsewhere") {
    Resource resource;
    resource.method = FormFactorMethod::automatic;
    CHECK(formFactorMethod(resource, read("cornell_1")) == FormFactorMethod::analytic);
    CHECK(formFactorMethod(resource, read("cornell_2")) == FormFactorMethod::hemicube);
    resource.method = FormFactorMethod::analytic;
    CHECK(formFactorMethod(resource, read("cornell_2")) == FormFactorMethod::analytic);
}

TEST_CASE("light escapes from open scenes, and from closed ones not at all") {
    const auto context = GlContext::offscreen();
    for (const auto& [name, expected] : scenes) {
        if (name == "dark") continue;
        const std::string which = name;
        CAPTURE(which);
        const Scene scene = read(name);
        PatchMesh mesh = meshed(scene, expected.patchSize);
        Progressive solver(mesh, formFactorsBy(FormFactorMethod::hemicube, 64));
        Limits limits;
        limits.shots = 40;
        solver.run(limits, [&, isClosed = expected.closed](const Progress& now) {
            CHECK(now.total() == Approx(now.emitted).epsilon(1e-5));
            if (isClosed) CHECK(std::abs(now.escaped) < 0.01 * now.emitted);
            return true;
        });
        CHECK(solver.progress().shots > 0);
        if (!expected.closed) CHECK(solver.progress().escaped > 0.05 * solver.progress().emitted);
    }
}

TEST_CASE("where nothing emits, nothing is shot and everything stays black") {
    const Scene scene = read("dark");
    PatchMesh mesh = meshed(scene, 0.25f);
    Progressive solver(mesh, calcAnalyticalFF);
    CHECK(solver.run(Limits{}).shots == 0);
    for (const MyPolygon& patch : mesh.patches) CHECK(patch.color == Vec3f(0.0f));
}

TEST_CASE("formula and hemicube agree on the empty Cornell box") {
    const Scene scene = read("cornell_1");
    const double byFormula = meanRadiosity(scene, 40, FormFactorMethod::analytic);
    const double byHemicube = meanRadiosity(scene, 40, FormFactorMethod::hemicube);
    CHECK(byFormula == Approx(byHemicube).epsilon(0.03));
}

TEST_CASE("blocks take light from the Cornell box's floor") {
    const double empty = meanRadiosity(read("cornell_1"), 60, FormFactorMethod::hemicube);
    const double furnished = meanRadiosity(read("cornell_2"), 60, FormFactorMethod::hemicube);
    CHECK(furnished < 0.95 * empty);
}

TEST_CASE("the grey room is grey to the last bit") {
    const auto context = GlContext::offscreen();
    PatchMesh mesh = meshed(read("grey_room"), 0.5f);
    Progressive solver(mesh, formFactorsBy(FormFactorMethod::hemicube, 64));
    Limits limits;
    limits.shots = 100;
    solver.run(limits);
    for (const MyPolygon& patch : mesh.patches) {
        CHECK(patch.rad.r == patch.rad.g);
        CHECK(patch.rad.r == patch.rad.b);
    }
}

TEST_CASE("the teapot is smooth over its bends and sharp at its rims") {
    const PatchMesh mesh = meshed(read("teapot"), 2);
    std::vector<const MyPolygon*> first(mesh.corners.size(), nullptr);
    std::set<int> potVertices;
    std::set<std::array<float, 3>> potPlaces;
    int shared = 0;
    for (const MyPolygon& patch : mesh.patches)
        for (int k = 0; k < patch.vertices; ++k) {
            const MyPolygon*& other = first[patch.vertex[k]];
            const Vec3f& place = mesh.corners[patch.vertex[k]].position;
            if (patch.vertices == 3) {
                potVertices.insert(patch.vertex[k]);
                potPlaces.insert({place.x, place.y, place.z});
            }
            if (other && dot(other->normal, patch.normal) < 0.9999f) ++shared;
            if (!other) other = &patch;
        }
    CHECK(shared > 3000);
    CHECK(mesh.corners.size() > 1000);
    CHECK(potVertices.size() > potPlaces.size() + 50);
}
