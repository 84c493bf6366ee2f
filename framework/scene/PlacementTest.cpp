#include "scene/Placement.h"

#include "scene/SceneTestHelp.h"

using namespace radlab;
using namespace radlab::test;

TEST_CASE("a translation moves a point") { checkClose(movedBy("translation='1 2 3'", "10 0 0"), {11, 2, 3}); }

TEST_CASE("a rotation turns by the right-hand rule, whatever the length of its axis") {
    checkClose(movedBy("rotation='0 0 1 1.5707963'", "1 0 0"), {0, 1, 0});
    checkClose(movedBy("rotation='0 0 20 1.5707963'", "1 0 0"), {0, 1, 0});
    checkClose(movedBy("rotation='1 0 0 1.5707963'", "0 1 0"), {0, 0, 1});
    checkClose(movedBy("rotation='0 1 0 1.5707963'", "0 0 1"), {1, 0, 0});
    checkClose(movedBy("rotation='0 0 -1 1.5707963'", "1 0 0"), {0, -1, 0});
    checkClose(movedBy("rotation='1 1 1 2.0943951'", "1 2 3"), {3, 1, 2});
    checkClose(movedBy("rotation='0 0 3e38 1.5707963'", "1 0 0"), {0, 1, 0});
}

TEST_CASE("a scale stretches each axis") { checkClose(movedBy("scale='2 3 -4'", "1 1 1"), {2, 3, -4}); }

TEST_CASE("a scale acts along the axes that scaleOrientation turns") {
    // Turned by 90 degrees, the scale of x acts along y.
    checkClose(movedBy("scale='2 1 1' scaleOrientation='0 0 1 1.5707963'", "1 1 0"), {1, 2, 0});
    // Turned by 45 degrees, (1,1) lies along the stretched axis and (-1,1) across it.
    checkClose(movedBy("scale='2 1 1' scaleOrientation='0 0 1 0.78539816'", "1 1 0"), {2, 2, 0});
    checkClose(movedBy("scale='2 1 1' scaleOrientation='0 0 1 0.78539816'", "-1 1 0"), {-1, 1, 0});
}

TEST_CASE("rotation and scale keep the center in its place") {
    checkClose(movedBy("center='1 0 0' rotation='0 0 1 3.1415927'", "1 0 0"), {1, 0, 0});
    checkClose(movedBy("center='1 0 0' rotation='0 0 1 3.1415927'", "3 0 0"), {-1, 0, 0});
    checkClose(movedBy("center='1 1 1' scale='3 3 3'", "2 1 1"), {4, 1, 1});
}

TEST_CASE("the pieces of a Transform apply in X3D's order") {
    // Scale about the center: (2,1,0)-(1,0,0) = (1,1,0) -> (2,1,0); turned: (-1,2,0); back: (0,2,0); moved: (0,2,10).
    checkClose(movedBy("translation='0 0 10' center='1 0 0' rotation='0 0 1 1.5707963' scale='2 1 1'", "2 1 0"),
               {0, 2, 10});
    // The same with the scale along y: (1,1,0) -> (1,2,0); turned: (-2,1,0); back and moved: (-1,1,10).
    checkClose(movedBy("translation='0 0 10' center='1 0 0' rotation='0 0 1 1.5707963' scale='2 1 1' "
                       "scaleOrientation='0 0 1 1.5707963'",
                       "2 1 0"),
               {-1, 1, 10});
}

TEST_CASE("a nested Transform applies before the one around it") {
    const Scene scene = parse("<Transform translation='10 0 0'><Group><Transform scale='2 2 2'>" + triangle() +
                              "</Transform></Group></Transform>");
    checkClose(scene.vertices[1], {12, 0, 0});
}

TEST_CASE("a negative scale keeps the front in front") {
    // Mirrored in z, a triangle that faced +z faces -z, and not the other way again.
    for (const char* scale : {"1 1 -1", "-1 -1 -1", "2 3 -4"}) {
        CAPTURE(scale);
        checkClose(normalOf(parse("<Transform scale='" + std::string(scale) + "'>" + triangle() + "</Transform>")),
                   {0, 0, -1});
    }
    for (const char* scale : {"-1 1 1", "1 -1 1", "-1 -1 1"}) {
        CAPTURE(scale);
        checkClose(normalOf(parse("<Transform scale='" + std::string(scale) + "'>" + triangle() + "</Transform>")),
                   {0, 0, 1});
    }
}

TEST_CASE("two mirrors around each other cancel out") {
    const Scene scene =
        parse("<Transform scale='-1 1 1'><Transform scale='1 -1 1'>" + triangle() + "</Transform></Transform>");
    CHECK(scene.faces[0].corners == std::vector<int>{0, 1, 2});
}

TEST_CASE("no axis at all is fine as long as nothing turns") {
    checkClose(movedBy("rotation='0 0 0 0'", "1 2 3"), {1, 2, 3});
    CHECK(contains(errorIn("<Transform rotation='0 0 0 1'>" + triangle() + "</Transform>"),
                   "scene.x3d:2: Transform: rotation turns about no axis"));
}

TEST_CASE("a scale of zero is an error, one that a float takes for zero too") {
    for (const char* scale : {"1 0 1", "1 1 1e-50"})
        CHECK(contains(errorIn("<Transform scale='" + std::string(scale) + "'>" + triangle() + "</Transform>"),
                       "scale flattens"));
}

TEST_CASE("coordinates that overflow through Transforms are an error") {
    const std::string big = "<Transform scale='1e30 1e30 1e30'>";
    CHECK(contains(errorIn(big + big + triangle() + "</Transform></Transform>"),
                   "point 1 (counted from 0) is too far out"));
}
