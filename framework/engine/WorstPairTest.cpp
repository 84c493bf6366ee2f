#include "engine/WorstPair.h"

#include <doctest/doctest.h>

#include "engine/ClosedFormRoom.h"

using namespace radlab::engine;
using doctest::Approx;

TEST_CASE("methods that take patches for points name a pair that is near, and what it should be") {
    const Geometry wedge = geometryOfFaces({onFloor(0, 0, 1, 1), onWall(0, 0, 1, 1)});
    const auto touching = worstPair(wedge, Method::point);
    REQUIRE(touching);
    CHECK(touching->from + touching->to == 1);
    CHECK(touching->exact == Approx(0.200043776075403).epsilon(1e-4));
    CHECK(touching->found > 0.25);
    // The centre sees nearly nothing but the ceiling, the rest of the floor sees out.
    const Geometry shifted = geometryOfFaces({onFloor(0, 0, 1, 1), onCeiling(0.4, 0, 0.02, 1, 1)});
    for (const Method method : {Method::polygon, Method::hemicube}) {
        CAPTURE(nameOf(method));
        const auto worst = worstPair(shifted, method);
        REQUIRE(worst);
        CHECK(worst->exact == Approx(0.6).epsilon(0.05));
        CHECK(worst->found > 0.8);
    }
    for (const Method method : {Method::exact, Method::hemisphere, Method::visibility, Method::automatic})
        CHECK(!worstPair(wedge, method));
}

TEST_CASE("nothing is named where patches are far from each other, or there are none") {
    CHECK(!worstPair(geometryOfFaces({onFloor(0, 0, 1, 1), onCeiling(0, 0, 10, 1, 1)}), Method::point));
    CHECK(!worstPair(Geometry(), Method::point));
    CHECK(!worstPair(geometryOfFaces({onFloor(0, 0, 1, 1), onFloor(1, 0, 1, 1)}), Method::polygon));
}
