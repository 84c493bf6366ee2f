#include "scene/X3dGeometry.h"

#include "scene/SceneTestHelp.h"

using namespace radlab;
using namespace radlab::test;

namespace {

const std::string square = "0 0 0 1 0 0 1 1 0 0 1 0";

std::string faceSet(const std::string& coordIndex, const std::string& points = square) {
    return "<Shape><IndexedFaceSet coordIndex='" + coordIndex + "'>" + coordinate(points) + "</IndexedFaceSet></Shape>";
}

std::string set(const std::string& kind, const std::string& fields) {
    return "<Shape><" + kind + " " + fields + ">" + coordinate(square) + "</" + kind + "></Shape>";
}

}  // namespace

TEST_CASE("creaseAngle reaches the faces, and is 0 where it is not given") {
    const auto faceWith = [](const std::string& field) {
        return parseX3d("<X3D><Scene><Shape><IndexedFaceSet coordIndex='0 1 2' " + field +
                            "><Coordinate point='0 0 0 1 0 0 0 1 0'/></IndexedFaceSet></Shape></Scene></X3D>",
                        "crease.x3d")
            .faces.at(0);
    };
    CHECK(faceWith("").creaseAngle == 0.0f);
    CHECK(faceWith("creaseAngle='0.5'").creaseAngle == 0.5f);
    CHECK(faceWith("creaseAngle='9'").creaseAngle == doctest::Approx(3.14159265));
    CHECK_THROWS_WITH_AS(faceWith("creaseAngle='-1'"), doctest::Contains("expected radians of at least 0"), Error);
}

TEST_CASE("a face set is cut at -1, and the last -1 may be missing") {
    for (const char* index : {"0 1 2 -1 0, 2, 3 -1", "0 1 2 -1 0 2 3"}) {
        const Scene scene = parse(faceSet(index));
        REQUIRE(scene.faces.size() == 2);
        CHECK(scene.faces[0].corners == std::vector<int>{0, 1, 2});
        CHECK(scene.faces[1].corners == std::vector<int>{0, 2, 3});
    }
}

TEST_CASE("faces of any number of corners keep them in order") {
    CHECK(parse(faceSet("3 2 1 0 -1")).faces[0].corners == std::vector<int>{3, 2, 1, 0});
    CHECK(parse(faceSet("0 1 2 3 4", square + " -1 0.5 0")).faces[0].corners == std::vector<int>{0, 1, 2, 3, 4});
}

TEST_CASE("triangle sets take three indices a face and quad sets four") {
    CHECK(parse(set("IndexedTriangleSet", "index='0 1 2 0 2 3'")).faces.size() == 2);
    CHECK(parse(set("IndexedQuadSet", "index='0 1 2 3'")).faces[0].corners == std::vector<int>{0, 1, 2, 3});
    CHECK(contains(errorIn(set("IndexedTriangleSet", "index='0 1 2 3'")), "4 entries, expected a multiple of 3"));
    CHECK(contains(errorIn(set("IndexedQuadSet", "index='0 1 2'")), "3 entries, expected a multiple of 4"));
}

TEST_CASE("ccw=\"false\" turns the front round") {
    checkClose(normalOf(parse(triangle())), {0, 0, 1});
    checkClose(normalOf(parse(triangle("ccw='false'"))), {0, 0, -1});
    checkClose(normalOf(parse(set("IndexedTriangleSet", "index='0 1 2' ccw='false'"))), {0, 0, -1});
    checkClose(normalOf(parse(set("IndexedQuadSet", "index='0 1 2 3' ccw='false'"))), {0, 0, -1});
}

TEST_CASE("ccw=\"false\" under a mirror is turned round twice") {
    checkClose(normalOf(parse("<Transform scale='-1 1 1'>" + triangle("ccw='false'") + "</Transform>")), {0, 0, -1});
}

TEST_CASE("only solid=\"false\" makes a face two-sided") {
    CHECK_FALSE(parse(triangle()).faces[0].twoSided);
    CHECK_FALSE(parse(triangle("solid='true'")).faces[0].twoSided);
    CHECK(parse(triangle("solid='false'")).faces[0].twoSided);
    CHECK(parse(triangle("solid='FALSE'")).faces[0].twoSided);
    CHECK(contains(errorIn(triangle("solid='no'")), "solid is neither true nor false, found 'no'"));
}

TEST_CASE("a polygon that repeats its first corner at the end is closed once") {
    CHECK(parse(faceSet("0 1 2 3 0 -1")).faces[0].corners == std::vector<int>{0, 1, 2, 3});
}

TEST_CASE("faces that repeated corners leave without area are left out with one warning") {
    const std::string nodes = faceSet("0 1 2 -1 0 0 1 -1 2 2 2 -1");
    CHECK(warningsIn(nodes) ==
          std::vector<std::string>{"scene.x3d: faces left out, since their repeated corners leave no area: 2"});
    const WarningCapture quiet;
    CHECK(contains(errorIn(faceSet("0 0 1")), "not a single face"));
}

TEST_CASE("an index without a point is named with the number of points") {
    CHECK(contains(errorIn(faceSet("0 1 2 -1 0 1 4")),
                   "scene.x3d:2: IndexedFaceSet: face 2 (counted from 1) has an index out of range, found 4 with 4 "
                   "points, expected 0 to 3"));
    CHECK(contains(errorIn(faceSet("0 1 -2")), "found -2"));
    CHECK(contains(errorIn(faceSet("0 1 2", "")), "found 0 with 0 points"));
    CHECK(contains(errorIn(set("IndexedTriangleSet", "index='0 1 -1'")), "found -1"));
}

TEST_CASE("a face needs three corners") {
    CHECK(contains(errorIn(faceSet("0 1 2 -1 0 1 -1")), "face 2 (counted from 1) has too few corners, found 2"));
    CHECK(contains(errorIn(faceSet("-1 0 1 2")), "face 1 (counted from 1) has too few corners, found 0"));
}

TEST_CASE("points come in threes and are numbers") {
    CHECK(contains(errorIn(faceSet("0 1 2", "0 0 0 1")), "Coordinate: point has 4 numbers, expected a multiple of 3"));
    CHECK(contains(errorIn(faceSet("0 1 2", "0 0 nan")), "Coordinate: point holds what is no number, found 'nan'"));
    CHECK(contains(errorIn(faceSet("0 1 2", "0 0 inf")), "found 'inf'"));
    CHECK(contains(errorIn(faceSet("0 1 2", "0 0 1e39")), "point holds a number too large, found '1e39'"));
    CHECK(contains(errorIn(faceSet("0 1 2.0")), "coordIndex holds what is no whole number, found '2.0'"));
    CHECK(contains(errorIn(faceSet("0 1 99999999999")), "no whole number, found '99999999999'"));
}

TEST_CASE("geometry without a Coordinate is an error on its line") {
    CHECK(contains(errorIn("<Shape>\n<IndexedFaceSet coordIndex='0 1 2'/></Shape>"),
                   "scene.x3d:3: IndexedFaceSet: there is no Coordinate below it"));
    CHECK(
        contains(errorIn("<Shape><IndexedFaceSet>" + coordinate() + "\n" + coordinate() + "</IndexedFaceSet></Shape>"),
                 "scene.x3d:3: Coordinate: a second one"));
}

TEST_CASE("a Coordinate is found inside wrappers below the geometry") {
    CHECK(warningsIn("<Shape><IndexedFaceSet coordIndex='0 1 2'><vertices><Group>" + coordinate() +
                     "</Group></vertices></IndexedFaceSet></Shape>")
              .empty());
}

TEST_CASE("each face knows the line of its geometry") {
    const Scene scene = parse(triangle() + "\n<Shape>\n" + "<IndexedQuadSet index='0 1 2 3'>\n" + coordinate(square) +
                              "</IndexedQuadSet></Shape>");
    CHECK(scene.faces[0].where.line == 2);
    CHECK(scene.faces[1].where.line == 4);
    CHECK(scene.faces[1].where.file == "scene.x3d");
}
