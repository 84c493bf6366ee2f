#include "scene/X3dSurvey.h"

#include "scene/SceneTestHelp.h"

using namespace radlab;
using namespace radlab::test;

TEST_CASE("USE repeats a node of every kind") {
    const std::string geometry =
        "<IndexedFaceSet DEF='G' coordIndex='0 1 2'><Coordinate DEF='C' "
        "point='0 0 0 1 0 0 0 1 0'/></IndexedFaceSet>";
    const std::string first =
        "<Transform DEF='T' translation='1 0 0'><Group DEF='Gr'><Shape DEF='S'><Appearance "
        "DEF='A'><Material DEF='M' diffuseColor='1 0 0'/></Appearance>" +
        geometry + "</Shape></Group></Transform>";
    struct Case {
        std::string nodes;
        bool red;
    };
    const std::vector<Case> cases = {
        {"<Transform USE='T'/>", true},
        {"<Group USE='Gr'/>", true},
        {"<Shape USE='S'/>", true},
        {"<Shape><Appearance USE='A'/><IndexedFaceSet USE='G'/></Shape>", true},
        {"<Shape><Appearance><Material USE='M'/></Appearance><IndexedFaceSet USE='G'/></Shape>", true},
        {"<Shape><IndexedFaceSet coordIndex='0 1 2'><Coordinate USE='C'/></IndexedFaceSet></Shape>", false},
    };
    for (const Case& used : cases) {
        CAPTURE(used.nodes);
        const Scene scene = parse(first + used.nodes);
        REQUIRE(scene.faces.size() == 2);
        CHECK(scene.vertices.size() == 6);
        CHECK(scene.faces[1].material->diffuse == (used.red ? Vec3f(1, 0, 0) : Vec3f(0.8f)));
    }
}

TEST_CASE("a node that is used stands where its user puts it") {
    const Scene scene =
        parse("<Group DEF='G'>" + triangle() + "</Group><Transform translation='0 0 7'><Group USE='G'/></Transform>");
    checkClose(scene.vertices[0], {0, 0, 0});
    checkClose(scene.vertices[3], {0, 0, 7});
}

TEST_CASE("a USE takes the last DEF of its name above it, with a warning") {
    const auto above = [](int height, const std::string& fields) {
        return "<Transform translation='0 0 " + std::to_string(height) + "'>" + withMaterial(fields) + "</Transform>";
    };
    const std::string nodes = above(0, "DEF='M' diffuseColor='1 0 0'") + above(1, "USE='M'") +
                              above(2, "DEF='M' diffuseColor='0 1 0'") + above(3, "USE='M'");
    WarningCapture capture;
    const Scene scene = parse(nodes);
    CHECK(scene.faces[1].material->diffuse == Vec3f(1, 0, 0));
    CHECK(scene.faces[3].material->diffuse == Vec3f(0, 1, 0));
    CHECK(capture.texts ==
          std::vector<std::string>{"scene.x3d: DEF names given again, a USE takes the last one above it: M (1)"});
}

TEST_CASE("inside a node that is used, names keep what they meant there") {
    // The second DEF of M comes after the group, whose own USE has to stay red.
    const Scene scene =
        parse(withMaterial("DEF='M' diffuseColor='1 0 0'") + "<Group DEF='G'>" + withMaterial("USE='M'") + "</Group>" +
              withMaterial("DEF='N' diffuseColor='0 1 0'") + "<Group USE='G'/>");
    CHECK(scene.faces[3].material->diffuse == Vec3f(1, 0, 0));
}

TEST_CASE("a USE without a DEF above it is an error") {
    CHECK(contains(errorIn("\n<Shape USE='S'/>" + triangle()), "scene.x3d:3: Shape: USE 'S' names no node"));
    CHECK(contains(errorIn("<Group USE='G'/><Group DEF='G'>" + triangle() + "</Group>"), "names no node"));
    CHECK(contains(errorIn("<Group USE=''/>" + triangle()), "USE '' names no node"));
}

TEST_CASE("a USE of another kind of node is an error") {
    CHECK(contains(errorIn("<Group DEF='G'>" + triangle() + "</Group>\n<Shape USE='G'/>"),
                   "scene.x3d:3: Shape: USE 'G' names another kind of node, found a 'Group' (line 2)"));
}

TEST_CASE("a node that uses itself is an error, however far around") {
    CHECK(contains(errorIn("<Group DEF='G'><Group USE='G'/></Group>" + triangle()), "a loop"));
    CHECK(contains(errorIn("<Group DEF='G'><Transform>\n<Group USE='G'/></Transform></Group>" + triangle()),
                   "scene.x3d:3: Group: USE 'G' stands inside the node that it names (line 2), a loop"));
    CHECK(contains(errorIn("<Group DEF='G' USE='G'/>" + triangle()), "both a DEF and a USE"));
    // Two that use each other: one of them comes first, and its USE has no DEF above it.
    CHECK(contains(errorIn("<Group DEF='A'><Group USE='B'/></Group><Group DEF='B'><Group USE='A'/></Group>"),
                   "USE 'B' names no node"));
}

TEST_CASE("everything unknown is named in one warning with its count") {
    const std::string nodes = "<Sphere radius='2'/><Group><Sphere/></Group><Transform spin='3'>" +
                              triangle("", "<Appearance><ImageTexture url='a'/><Material/></Appearance>") +
                              "</Transform>";
    CHECK(warningsIn(nodes) ==
          std::vector<std::string>{"scene.x3d: passed over: Sphere (2), Transform.spin (1), ImageTexture (1)"});
}

TEST_CASE("many unknown names do not make an endless line") {
    std::string nodes = triangle();
    for (int i = 0; i < 30; ++i) nodes += "<Unknown" + std::to_string(i) + "/>";
    const auto warnings = warningsIn(nodes);
    REQUIRE(warnings.size() == 1);
    CHECK(contains(warnings[0], "Unknown19 (1) and 10 more names"));
}

TEST_CASE("a known node in a place where nobody looks is named too") {
    CHECK(warningsIn(triangle() + "<Material/>") == std::vector<std::string>{"scene.x3d: passed over: Material (1)"});
    CHECK(warningsIn(triangle() + "<IndexedFaceSet coordIndex='0 1 2'>" + coordinate() + "</IndexedFaceSet>") ==
          std::vector<std::string>{"scene.x3d: passed over: IndexedFaceSet (1)"});
}

TEST_CASE("what cannot matter for light is passed over without a word") {
    CHECK(warningsIn("<WorldInfo title='t'/><Group bboxCenter='0 0 0' bboxSize='1 1 1' class='c' id='i'>"
                     "<MetadataString name='n' value='v'/>" +
                     withMaterial("ambientIntensity='0.3' containerField='material'") +
                     "<Transform translation='0 0 1'><Shape><IndexedFaceSet coordIndex='0 1 2' creaseAngle='1' "
                     "convex='false' normalPerVertex='true' "
                     "colorPerVertex='false' normalIndex='0' texCoordIndex='0 1 2'>" +
                     coordinate() + "<Normal vector='0 0 1'/><TextureCoordinate point='0 0'/><Color color='1 1 1'/>" +
                     "</IndexedFaceSet></Shape></Transform></Group>")
              .empty());
}

TEST_CASE("a node inside one that is passed over can still be used") {
    const WarningCapture quiet;
    CHECK(parse("<Switch whichChoice='-1'><Group DEF='G'>" + triangle() + "</Group></Switch><Group USE='G'/>")
              .faces.size() == 1);
}

TEST_CASE("nodes that are passed over may use what nobody knows") {
    CHECK(warningsIn("<Script USE='nowhere'/><Switch><Group USE='nowhere'/></Switch>" + triangle()).size() == 1);
}

TEST_CASE("the names inside a prototype are its own") {
    CHECK(contains(errorIn("<ProtoDeclare name='P'><ProtoBody><Group DEF='G'/></ProtoBody></ProtoDeclare><Group "
                           "USE='G'/>" +
                           triangle()),
                   "USE 'G' names no node"));
}

TEST_CASE("a field that is given twice is an error") {
    CHECK(contains(errorIn(withMaterial("shininess='0.1' shininess='0.2'")),
                   "scene.x3d:2: an attribute cannot be read, expected name=\"value\" with each name once"));
}
