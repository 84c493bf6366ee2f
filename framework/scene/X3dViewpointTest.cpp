#include "scene/X3dViewpoint.h"

#include "scene/SceneTestHelp.h"

using namespace radlab;
using namespace radlab::test;

namespace {

Camera cameraIn(const std::string& nodes) { return parse(nodes + triangle()).cameras.at(0); }

}  // namespace

TEST_CASE("a scene without Viewpoints has no cameras") { CHECK(parse(triangle()).cameras.empty()); }

TEST_CASE("a Viewpoint without fields stands at z = 10 and looks along -z") {
    const Camera camera = cameraIn("<Viewpoint/>");
    checkClose(camera.position, {0, 0, 10});
    checkClose(camera.direction, {0, 0, -1});
    checkClose(camera.up, {0, 1, 0});
    CHECK(camera.fieldOfView == doctest::Approx(0.785398));
    CHECK(camera.name == "");
}

TEST_CASE("an orientation turns the view") {
    const Camera camera = cameraIn("<Viewpoint position='1 2 3' orientation='0 1 0 1.5707963' fieldOfView='1.2'/>");
    checkClose(camera.position, {1, 2, 3});
    checkClose(camera.direction, {-1, 0, 0});
    checkClose(camera.up, {0, 1, 0});
    CHECK(camera.fieldOfView == 1.2f);
    checkClose(cameraIn("<Viewpoint orientation='0 0 1 1.5707963'/>").up, {-1, 0, 0});
}

TEST_CASE("a camera is named by its description, or else its DEF") {
    CHECK(cameraIn("<Viewpoint DEF='V' description='From the \"left\"'/>").name == "From the \"left\"");
    CHECK(cameraIn("<Viewpoint DEF='V'/>").name == "V");
}

TEST_CASE("a Viewpoint moves with the Transforms around it") {
    const Camera camera = cameraIn(
        "<Transform translation='0 0 5'><Transform rotation='0 1 0 1.5707963'>"
        "<Viewpoint position='0 0 10'/></Transform></Transform>");
    checkClose(camera.position, {10, 0, 5});
    checkClose(camera.direction, {-1, 0, 0});
    checkClose(camera.up, {0, 1, 0});
}

TEST_CASE("direction and up stay unit vectors at a right angle under a shear") {
    const Camera camera = cameraIn("<Transform scale='1 5 1'><Viewpoint orientation='1 0 0 -0.7'/></Transform>");
    CHECK(glm::length(camera.direction) == doctest::Approx(1));
    CHECK(glm::length(camera.up) == doctest::Approx(1));
    CHECK(glm::dot(camera.direction, camera.up) == doctest::Approx(0));
    CHECK(camera.up.y > 0);
}

TEST_CASE("cameras keep the order of the file") {
    const Scene scene = parse("<Viewpoint description='a'/><Group><Viewpoint description='b'/></Group>" + triangle() +
                              "<Viewpoint description='c'/>");
    REQUIRE(scene.cameras.size() == 3);
    CHECK(scene.cameras[0].name + scene.cameras[1].name + scene.cameras[2].name == "abc");
}

TEST_CASE("fields that do not matter here are passed over without a word") {
    CHECK(warningsIn("<Viewpoint centerOfRotation='0 1 0' jump='true'/><NavigationInfo type='\"EXAMINE\" \"ANY\"'/>" +
                     triangle())
              .empty());
}

TEST_CASE("a field of view lies between 0 and pi") {
    for (const char* angle : {"0", "-1", "3.1416", "3.14159265", "1e-50"}) {
        CAPTURE(angle);
        CHECK(contains(errorIn("<Viewpoint fieldOfView='" + std::string(angle) + "'/>" + triangle()),
                       "scene.x3d:2: Viewpoint: fieldOfView is out of range"));
    }
    CHECK(cameraIn("<Viewpoint fieldOfView='3.1415'/>").fieldOfView > 3);
}

TEST_CASE("an orientation about no axis is an error") {
    CHECK(contains(errorIn("<Viewpoint orientation='0 0 0 1'/>" + triangle()), "orientation turns about no axis"));
}

TEST_CASE("a Viewpoint that Transforms put out of the world is an error") {
    const std::string big = "<Transform scale='1e30 1e30 1e30'>";
    CHECK(contains(errorIn(big + big + "<Viewpoint/></Transform></Transform>" + triangle()), "place it nowhere"));
}
