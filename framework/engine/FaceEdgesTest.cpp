#include "engine/FaceEdges.h"

#include <doctest/doctest.h>

#include "engine/ClosedFormRoom.h"

using namespace radlab::engine;

TEST_CASE("every edge of a box goes on in another side, and none where a side is left out") {
    const std::vector<Polygon> sides = boxSides(1, 2, 3);
    const FaceEdges whole(sides, std::vector<bool>(6, true));
    std::vector<bool> open(6, true);
    open[1] = false;
    const FaceEdges lidless(sides, open);
    for (std::size_t side = 0; side < 6; ++side) {
        CHECK(whole.of(side).size() == 4);
        for (const FaceEdges::Edge& edge : whole.of(side)) {
            CHECK(edge.beyond < 6);
            CHECK(edge.beyond != side);
            CHECK_FALSE(edge.turned);
        }
        for (std::size_t i = 0; i < lidless.of(side).size(); ++i)
            CHECK((lidless.of(side)[i].beyond == FaceEdges::none) == (whole.of(side)[i].beyond == 1));
    }
    CHECK(lidless.of(1).empty());
}

TEST_CASE("an edge knows a neighbour that is turned over, and takes none of three") {
    const Polygon left = onFloor(0, 0, 1, 1), right = onFloor(1, 0, 1, 1), up = onWall(0, 0, 1, 1);
    const Polygon turned(std::vector<Point>(right.corners.rbegin(), right.corners.rend()));
    const auto shared = [](const std::vector<Polygon>& faces) {
        const FaceEdges edges(faces, std::vector<bool>(faces.size(), true));
        for (const FaceEdges::Edge& edge : edges.of(0))
            if (edge.from.x + edge.to.x == 2.0) return edge;
        return FaceEdges::Edge{};
    };
    CHECK(shared({left, right}).beyond == 1);
    CHECK_FALSE(shared({left, right}).turned);
    CHECK(shared({left, turned}).beyond == 1);
    CHECK(shared({left, turned}).turned);
    std::vector<Point> corners = up.corners;
    for (Point& corner : corners) corner.x += 1.0;
    CHECK(shared({left, right, Polygon(corners)}).beyond == FaceEdges::none);
}
