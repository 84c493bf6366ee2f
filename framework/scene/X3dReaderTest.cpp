#include "scene/X3dReader.h"

#include <filesystem>
#include <fstream>

#include "scene/SceneTestHelp.h"
#include "scene/XmlText.h"

using namespace radlab;
using namespace radlab::test;

namespace {

const char* const exported = R"(<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE X3D PUBLIC "ISO//Web3D//DTD X3D 3.0//EN" "http://www.web3d.org/specifications/x3d-3.0.dtd">
<X3D version="3.0" profile="Immersive" xmlns:xsd="http://www.w3.org/2001/XMLSchema-instance"
     xsd:noNamespaceSchemaLocation="http://www.web3d.org/specifications/x3d-3.0.xsd">
    <head>
        <meta name="generator" content="Blender 2.79" />
        <component name="Shape" level="4"/>
    </head>
    <Scene>
        <NavigationInfo headlight="false" visibilityLimit="0.0" type='"EXAMINE", "ANY"' avatarSize="0.25, 1.75, 0.75" />
        <Background DEF="WO_World" groundColor="0.05 0.05 0.05" skyColor="0.25 0.5 0.75, 1 1 1" />
        <Transform DEF="Cube_TRANSFORM" translation="0.000000 0.000000 1.000000" scale="2.000000 2.000000 2.000000"
                   rotation="0.000000 0.707107 0.707107 3.141593">
            <Group DEF="group_ME_Cube">
                <Shape>
                    <Appearance>
                        <Material DEF="MA_Material" diffuseColor="0.640 0.640 0.640" specularColor="0.401 0.401 0.401"
                                  emissiveColor="0.000 0.000 0.000" ambientIntensity="0.333" shininess="0.098"
                                  transparency="0.0" />
                    </Appearance>
                    <IndexedFaceSet solid="true" coordIndex="0 1 2 3 -1 4 7 6 5 -1 ">
                        <Coordinate DEF="coords_ME_Cube" point="1.0 1.0 -1.0 1.0 -1.0 -1.0 -1.0 -1.0 -1.0 -1.0 1.0 -1.0
                                    1.0 1.0 1.0 1.0 -1.0 1.0 -1.0 -1.0 1.0 -1.0 1.0 1.0 " />
                    </IndexedFaceSet>
                </Shape>
            </Group>
        </Transform>
        <PointLight DEF="LA_Lamp" location="4.0762 5.9039 -1.0055" on="true" />
        <Viewpoint DEF="CA_Camera" centerOfRotation="0 0 0" position="7.48 5.34 6.51"
                   orientation="-0.16 -0.98 -0.06 -0.85" fieldOfView="0.858" />
    </Scene>
</X3D>
)";

}  // namespace

TEST_CASE("a file as an exporter writes it is read whole") {
    WarningCapture capture;
    const Scene scene = parseX3d(exported, "cube.x3d");
    CHECK(scene.file == "cube.x3d");
    CHECK(scene.vertices.size() == 8);
    CHECK(scene.faces.size() == 2);
    CHECK(scene.faces[0].where.line == 21);
    CHECK(scene.faces[0].material->diffuse == Vec3f(0.64f));
    CHECK(scene.background == Vec3f(0.25f, 0.5f, 0.75f));
    CHECK(scene.cameras.at(0).name == "CA_Camera");
    // Half a turn about the diagonal of y and z swaps them and turns x round.
    checkClose(scene.vertices[0], {-2, -2, 3});
    CHECK(capture.texts == std::vector<std::string>{"cube.x3d: passed over: PointLight (1)"});
}

TEST_CASE("the course's older layout has its geometry inside the Appearance") {
    const Scene scene = parse("<Shape><Appearance><Material diffuseColor='1 0 0'/><IndexedFaceSet coordIndex='0 1 2'>" +
                              coordinate() + "</IndexedFaceSet></Appearance></Shape>");
    REQUIRE(scene.faces.size() == 1);
    CHECK(scene.faces[0].material->diffuse == Vec3f(1, 0, 0));
}

TEST_CASE("geometry ahead of its Appearance has its material all the same") {
    const Scene scene = parse("<Shape><IndexedFaceSet coordIndex='0 1 2'>" + coordinate() +
                              "</IndexedFaceSet><Appearance><Material diffuseColor='1 0 0'/></Appearance></Shape>");
    CHECK(scene.faces[0].material->diffuse == Vec3f(1, 0, 0));
}

TEST_CASE("a Shape has one geometry, one Appearance and one Material") {
    const std::string geometry = "<IndexedFaceSet coordIndex='0 1 2'>" + coordinate() + "</IndexedFaceSet>";
    CHECK(contains(errorIn("<Shape>" + geometry + "\n" + geometry + "</Shape>"),
                   "scene.x3d:3: IndexedFaceSet: a second one in the same Shape"));
    const std::string both = "<Shape>" + geometry + "<Appearance>" + geometry + "</Appearance></Shape>";
    CHECK(contains(errorIn(both), "a second one"));
    CHECK(contains(errorIn(triangle("", "<Appearance/><Appearance/>")), "Appearance: a second one"));
    CHECK(contains(errorIn(triangle("", "<Appearance><Material/><Material/></Appearance>")), "Material: a second one"));
}

TEST_CASE("any namespace prefix is accepted") {
    const Scene scene = parseX3d(
        "<x3d:X3D xmlns:x3d='u'><x3d:Scene><x3d:Shape><x3d:IndexedFaceSet coordIndex='0 1 "
        "2'><x3d:Coordinate point='0 0 0 1 0 0 0 1 0'/></x3d:IndexedFaceSet></x3d:Shape>"
        "</x3d:Scene></x3d:X3D>",
        "f");
    CHECK(scene.faces.size() == 1);
}

TEST_CASE("comments may stand anywhere and a Scene may be the root") {
    CHECK(parseX3d("<!-- a --><Scene><!-- b -->" + triangle() + "<!-- c --></Scene><!-- d -->", "f").faces.size() == 1);
}

TEST_CASE("each Shape has its own copy of the points, and materials may be shared") {
    const Scene scene = parse(triangle() + triangle());
    CHECK(scene.vertices.size() == 6);
    CHECK(scene.faces[1].corners == std::vector<int>{3, 4, 5});
}

TEST_CASE("the first Background counts, and its first colour") {
    CHECK(parse(triangle()).background == Vec3f(0));
    CHECK(parse("<Background skyColor='0 0 1 1 1 1'/><Background skyColor='1 0 0'/>" + triangle()).background ==
          Vec3f(0, 0, 1));
    CHECK(contains(errorIn("<Background skyColor='0 0'/>" + triangle()), "skyColor has 2 numbers"));
    CHECK(contains(errorIn("<Background skyColor='0 0 2'/>" + triangle()), "skyColor is out of range, found 2"));
}

TEST_CASE("a file without a Scene, with two, or without a face is an error") {
    CHECK(contains(errorOf([] { parseX3d("<X3D/>", "f"); }), "f:1: X3D: there is no Scene in this file"));
    CHECK(contains(errorOf([] { parseX3d("<X3D>\n<Scene/>\n<Scene/></X3D>", "f"); }), "f:3: Scene: a second Scene"));
    CHECK(contains(errorIn("<Group/>"), "scene.x3d:1: Scene: there is not a single face in it"));
}

TEST_CASE("no cut of a good file crashes, and every cut is an error with a line") {
    const std::string whole(exported);
    for (std::size_t length = 1; length < whole.find("</Scene>"); length += 7) {
        CAPTURE(length);
        const WarningCapture quiet;
        const std::string message = errorOf([&] { parseX3d(std::string_view(whole).substr(0, length), "f"); });
        CHECK(message.starts_with("f"));
    }
}

TEST_CASE("a billion laughs end in an error that names the limit") {
    std::string nodes = "<Group DEF='G0'>" + triangle() + "</Group>";
    for (int i = 1; i <= 30; ++i) {
        const std::string use = "<Group USE='G" + std::to_string(i - 1) + "'/>";
        nodes += "<Group DEF='G" + std::to_string(i) + "'>" + use + use + "</Group>";
    }
    const auto errorWith = [&](const X3dLimits& limits) { return errorOf([&] { parseX3d(x3d(nodes), "f", limits); }); };
    CHECK(contains(errorWith({100, 10000, 10000, 10000, 10}), "expected at most 100 faces"));
    CHECK(contains(errorWith({10000, 100, 10000, 10000, 10}), "expected at most 100 vertices"));
    CHECK(contains(errorWith({10000, 10000, 100, 10000, 10}), "expected at most 100 corners of faces"));
    CHECK(contains(errorWith({10000, 10000, 10000, 100, 10}), "expected at most 100 nodes"));
}

TEST_CASE("comments count among the nodes, since walking them takes time") {
    std::string nodes = triangle() + "<Group DEF='G'>";
    for (int i = 0; i < 100; ++i) nodes += "<!---->";
    nodes += "</Group>";
    for (int i = 0; i < 100; ++i) nodes += "<Group USE='G'/>";
    CHECK(contains(errorOf([&] { parseX3d(x3d(nodes), "f", {10, 10, 10, 1000, 10}); }), "at most 1000 nodes"));
}

TEST_CASE("too many Viewpoints are an error") {
    const std::string nodes = "<Viewpoint/><Viewpoint/><Viewpoint/>" + triangle();
    CHECK(contains(errorOf([&] { parseX3d(x3d(nodes), "f", {10, 10, 10, 100, 2}); }), "at most 2 viewpoints"));
}

TEST_CASE("a long chain of USE is an error, not a crash") {
    std::string nodes = "<Group DEF='G0'>" + triangle() + "</Group>";
    for (int i = 1; i <= 300; ++i)
        nodes += "<Group DEF='G" + std::to_string(i) + "'><Group USE='G" + std::to_string(i - 1) + "'/></Group>";
    CHECK(contains(errorIn(nodes), "nested too deeply by USE, expected at most 200 levels"));
}

TEST_CASE("a file is read from disk under its own name") {
    const auto file = std::filesystem::temp_directory_path() / "radlab-reader-test.x3d";
    std::ofstream(file, std::ios::binary) << x3d(triangle());
    CHECK(readX3d(file).file == pathText(file));
    std::filesystem::remove(file);
    CHECK(contains(errorOf([&] { readX3d(file); }), "there is no such file"));
}
