#include "scene/Occlusion.h"

#include <cmath>
#include <ctime>

#include "scene/SceneTestHelp.h"

using namespace radlab;
using namespace radlab::test;

namespace {

const std::string cube = "0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1";
const std::string inward = "index='0 1 2 3 4 7 6 5 0 4 5 1 1 5 6 2 2 6 7 3 3 7 4 0'";

std::string quads(const std::string& fields, const std::string& points) {
    return "<Shape><IndexedQuadSet " + fields + ">" + coordinate(points) + "</IndexedQuadSet></Shape>\n";
}

const std::string room = quads(inward, cube);
const std::string block =
    "<Transform translation='0.4 0.4 0.4' scale='0.2 0.2 0.2'>" + quads(inward + " ccw='false'", cube) + "</Transform>";

/// A sphere seen from inside, with rings of quads.
Scene sphere(int rings) {
    Scene scene;
    const auto material = std::make_shared<const Material>();
    for (int i = 0; i <= rings; ++i)
        for (int j = 0; j < 2 * rings; ++j) {
            const float theta = 3.14159265f * (float(i) + 0.5f) / float(rings + 1);
            const float phi = 3.14159265f * float(j) / float(rings);
            const float radius = std::sin(theta);
            scene.vertices.emplace_back(radius * std::cos(phi), radius * std::sin(phi), std::cos(theta));
        }
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < 2 * rings; ++j) {
            const int next = (j + 1) % (2 * rings), row = i * 2 * rings, below = row + 2 * rings;
            scene.faces.push_back({{row + j, row + next, below + next, below + j}, material, false, {"s", i}});
        }
    return scene;
}

}  // namespace

TEST_CASE("nothing is hidden in an empty room") {
    const Occlusion occlusion = findOcclusion(parse(room));
    CHECK_FALSE(occlusion.found);
    CHECK(occlusion.reason == "no corner lies behind any of the 6 faces, from scene.x3d:2 to scene.x3d:2");
}

TEST_CASE("a block in a room hides what is behind it") {
    const Occlusion occlusion = findOcclusion(parse(room + block));
    CHECK(occlusion.found);
    CHECK(occlusion.reason ==
          "the face at scene.x3d:3 may hide others, a corner of the face at scene.x3d:2 lies behind it");
}

TEST_CASE("two facing squares hide nothing from each other") {
    CHECK_FALSE(findOcclusion(parse(quads("index='0 1 2 3 4 7 6 5'", cube))).found);
}

TEST_CASE("points that no face uses do not count") {
    CHECK_FALSE(findOcclusion(parse(quads(inward, cube + " 0.5 0.5 -9"))).found);
}

TEST_CASE("a face that looks away counts as one that may hide") {
    CHECK(findOcclusion(parse(quads("index='0 3 2 1 4 7 6 5'", cube))).found);
}

TEST_CASE("a two-sided face hides nothing where everything is on one side of it, whichever that is") {
    CHECK_FALSE(findOcclusion(parse(quads("solid='false' index='0 3 2 1 4 5 6 7'", cube))).found);
    const std::string screen = quads("solid='false' index='0 1 2 3'", "0 0 0.5 1 0 0.5 1 1 0.5 0 1 0.5");
    CHECK(findOcclusion(parse(room + screen)).found);
}

TEST_CASE("a corner behind a plane by rounding alone hides nothing") {
    const std::string bent = "0 0 0 1 0 0 1 1 0.000001 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1";
    CHECK_FALSE(findOcclusion(parse(quads(inward, bent))).found);
    const std::string dented = "0 0 0 1 0 0 1 1 0.01 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1";
    CHECK(findOcclusion(parse(quads(inward, dented))).found);
}

TEST_CASE("the answer does not depend on the scene's unit") {
    for (const char* unit : {"1e-6", "1e6", "1e30"}) {
        CAPTURE(unit);
        const std::string scale = "<Transform scale='" + std::string(unit) + " " + unit + " " + unit + "'>";
        CHECK_FALSE(findOcclusion(parse(scale + room + "</Transform>")).found);
        CHECK(findOcclusion(parse(scale + room + block + "</Transform>")).found);
    }
}

TEST_CASE("a face without area decides nothing, nor does an empty scene") {
    CHECK_FALSE(findOcclusion(parse(room + quads("index='0 1 2 3'", "0 0 0 1 0 0 0.5 0 0 0.2 0 0"))).found);
    CHECK_FALSE(findOcclusion(Scene()).found);
}

TEST_CASE("faces of one tilted wall are settled together") {
    std::string nodes = "<Transform rotation='1 2 3 1'><Shape DEF='S'><IndexedFaceSet coordIndex='0 1 2'>" +
                        coordinate() +
                        "</IndexedFaceSet></Shape></Transform><Group DEF='G0'><Transform rotation='1 2 "
                        "3 1'><Shape USE='S'/></Transform></Group>";
    for (int i = 1; i <= 15; ++i) {
        const std::string use = "<Group USE='G" + std::to_string(i - 1) + "'/>";
        nodes += "<Group DEF='G" + std::to_string(i) + "'>" + use + use + "</Group>";
    }
    const Scene scene = parse(nodes);
    const std::clock_t start = std::clock();
    CHECK(scene.faces.size() == 65536);
    CHECK_FALSE(findOcclusion(scene).found);
    CHECK(std::clock() - start < 20 * CLOCKS_PER_SEC);
}

TEST_CASE("many flat faces in a round room are settled in little time") {
    const std::clock_t start = std::clock();
    CHECK_FALSE(findOcclusion(sphere(50)).found);
    CHECK(std::clock() - start < 20 * CLOCKS_PER_SEC);
}
