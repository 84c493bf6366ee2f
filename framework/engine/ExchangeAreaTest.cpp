#include "engine/ExchangeArea.h"

#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

#include "engine/ClosedFormRoom.h"

using namespace radlab::engine;
using doctest::Approx;

namespace {

constexpr double pi = std::numbers::pi;

double formFactor(const Polygon& from, const Polygon& to) { return exchangeArea(from, to) / from.area; }

// Parallel w x h rectangles at distance 1.
double parallel(double x, double y) { return formFactor(onFloor(0, 0, x, y), onCeiling(0, 0, 1, x, y)); }

// A floor w wide and a wall h high that share an edge of length 1.
double perpendicular(double w, double h) {
    return formFactor(parallelogram(Point(0), Point(w, 0, 0), Point(0, 1, 0)),
                      parallelogram(Point(0), Point(0, 1, 0), Point(0, 0, h)));
}

double wedge(double degrees) {
    const double angle = degrees * pi / 180.0;
    return formFactor(parallelogram(Point(0), Point(1, 0, 0), Point(0, 1, 0)),
                      parallelogram(Point(0), Point(0, 1, 0), Point(std::cos(angle), 0, std::sin(angle))));
}

}  // namespace

TEST_CASE("exchange area: parallel rectangles match the closed form") {
    CHECK(parallel(1, 1) == Approx(0.199824895698387).epsilon(1e-12));
    CHECK(parallel(0.1, 0.1) == Approx(0.003162056838758).epsilon(1e-12));
    CHECK(parallel(1, 5) == Approx(0.359166526336609).epsilon(1e-12));
    CHECK(parallel(100, 100) == Approx(0.980416602925973).epsilon(1e-12));
}

TEST_CASE("exchange area: perpendicular rectangles with a common edge match the closed form") {
    CHECK(perpendicular(1, 1) == Approx(0.200043776075403).epsilon(1e-12));
    CHECK(perpendicular(0.5, 1) == Approx(0.292373358211427).epsilon(1e-12));
    CHECK(perpendicular(1, 5) == Approx(0.246899005671689).epsilon(1e-12));
}

TEST_CASE("exchange area: squares that share an edge at any angle") {
    CHECK(wedge(30) == Approx(0.619028323091).epsilon(1e-11));
    CHECK(wedge(60) == Approx(0.370905321150).epsilon(1e-11));
    CHECK(wedge(90) == Approx(0.200043776075403).epsilon(1e-12));
    CHECK(wedge(120) == Approx(0.086615001118).epsilon(1e-11));
    CHECK(wedge(165) == Approx(0.005317985921).epsilon(1e-10));
}

TEST_CASE("exchange area: skew triangles") {
    const Polygon a({Point(0), Point(1, 0, 0), Point(0, 1, 0)});
    const Polygon b({Point(.2, .1, 1), Point(.3, .9, 1.4), Point(1.2, .3, .8)});
    CHECK(formFactor(a, b) == Approx(0.0794017110027708).epsilon(1e-12));
}

namespace {

struct Row {
    const char* what;
    Polygon from, to;
    double truth;  // of the closed form for rectangles, computed with 60 digits
};

}  // namespace

TEST_CASE("exchange area: far, near, thin and unequal rectangles match the closed form to ten digits, both ways") {
    const Row rows[] = {
        {"100 sizes apart", onFloor(0, 0, 1, 1), onCeiling(0, 0, 100, 1, 1), 3.1828866732829196e-5},
        {"1,000 sizes apart", onFloor(0, 0, 1, 1), onCeiling(0, 0, 1000, 1, 1), 3.1830967397738026e-7},
        {"10,000 sizes apart", onFloor(0, 0, 1, 1), onCeiling(0, 0, 10000, 1, 1), 3.1830988406172478e-9},
        {"a gap of 1e-4", onFloor(0, 0, 1, 1), onCeiling(0, 0, 1e-4, 1, 1), 0.99980007097778849},
        {"a gap of 1e-6", onFloor(0, 0, 1, 1), onCeiling(0, 0, 1e-6, 1, 1), 0.99999800001002952},
        {"a gap of 1e-8", onFloor(0, 0, 1, 1), onCeiling(0, 0, 1e-8, 1, 1), 0.9999999800000013},
        {"set off by 10", onFloor(0, 0, 1, 1), onCeiling(10, 0, 1, 1, 1), 3.1613637304168129e-5},
        {"set off by 1,000", onFloor(0, 0, 1, 1), onCeiling(1000, 0, 1, 1, 1), 3.1830967397667998e-13},
        {"a wall 10 away", onFloor(10, 0, 1, 1), onWall(0, 0, 1, 1), 0.0001364474034390309},
        {"a wall 1,000 away", onFloor(1000, 0, 1, 1), onWall(0, 0, 1, 1), 1.5891631691286935e-10},
        {"a wall set off by 10", onFloor(0, 0, 1, 1), onWall(10, 0, 1, 1), 7.9303027085430681e-6},
        {"areas 1e-8, facing", onFloor(0, 0, 1e-4, 1e-4), onCeiling(0, 0, 1, 1, 1), 0.13854594799098763},
        {"areas 1e-12, facing", onFloor(0, 0, 1e-6, 1e-6), onCeiling(0, 0, 1, 1, 1), 0.13853174941365135},
        {"areas 1e-8, near", onFloor(.5, .5, 1e-4, 1e-4), onCeiling(0, 0, 1e-3, 1, 1), 0.99999672677140028},
        {"areas 1e-12, near", onFloor(.5, .5, 1e-6, 1e-6), onCeiling(0, 0, 1e-3, 1, 1), 0.99999672677154817},
        {"areas 1e-8, on an edge", onFloor(0, .25, 1e-4, 1e-4), onWall(0, 0, 1, 1), 0.49995049392263903},
        {"areas 1e-12, on an edge", onFloor(0, .25, 1e-6, 1e-6), onWall(0, 0, 1, 1), 0.49999950488439855},
        {"areas 1e-8, in a corner", onFloor(0, 0, 1e-4, 1e-4), onWall(0, 0, 1, 1), 0.37498579165603331},
        {"areas 1e-12, in a corner", onFloor(0, 0, 1e-6, 1e-6), onWall(0, 0, 1, 1), 0.37499985792246877},
        {"a strip of 1e-4 along a wall", onFloor(0, 0, 1e-4, 1), onWall(0, 0, 1, 1), 0.49982255552878213},
        {"a strip of 1e-6 along a wall", onFloor(0, 0, 1e-6, 1), onWall(0, 0, 1, 1), 0.49999749261968876},
        {"two strips of 1e-4 that touch", onFloor(0, 0, 1e-4, 1), onWall(0, 0, 1, 1e-4), 0.29288218703347137},
        {"two strips of 1e-6 that touch", onFloor(0, 0, 1e-6, 1), onWall(0, 0, 1, 1e-6), 0.2928931084956524},
        {"a strip of 1e-6 below a square", onFloor(0, 0, 1e-6, 1), onCeiling(0, 0, 1, 1, 1), 0.16559490835175575},
    };
    for (const Row& row : rows) {
        CAPTURE(row.what);
        CHECK(exchangeArea(row.from, row.to) / row.from.area == Approx(row.truth).epsilon(1e-10));
        CHECK(exchangeArea(row.to, row.from) / row.from.area == Approx(row.truth).epsilon(1e-10));
    }
}

TEST_CASE("exchange area: nothing passes between polygons in one plane, back to back, or turned away") {
    const Polygon floor = onFloor(0, 0, 1, 1);
    CHECK(exchangeArea(floor, onFloor(1, 0, 1, 1)) == 0.0);
    CHECK(exchangeArea(floor, floor) == 0.0);
    CHECK(exchangeArea(floor, onCeiling(0, 0, 0, 1, 1)) == 0.0);
    CHECK(exchangeArea(floor, onCeiling(0, 0, -1, 1, 1)) == 0.0);
    CHECK(exchangeArea(floor, onFloor(0, 0, 0, 1)) == 0.0);
    CHECK(exchangeArea(onWall(0, 0, 1, 1), onFloor(-1, 0, 1, 1)) == 0.0);
}

TEST_CASE("exchange area: a polygon that the other's plane cuts counts with its front part") {
    const Polygon floor = onFloor(0, 0, 1, 1), through = onWall(0, -1, 1, 2), above = onWall(0, 0, 1, 1);
    CHECK(exchangeArea(floor, through) == Approx(exchangeArea(floor, above)).epsilon(1e-13));
    CHECK(exchangeArea(through, onFloor(-1, 0, 2, 1)) == Approx(exchangeArea(above, floor)).epsilon(1e-13));
}

TEST_CASE("exchange area: the whole is the sum of its parts, at any distance and angle") {
    for (const double distance : {0.0, 1e-9, 1e-3, 0.3, 2.0, 5.0, 20.0, 300.0})
        for (const double angle : {0.1, 0.7, 1.5}) {
            CAPTURE(distance);
            CAPTURE(angle);
            const Polygon a = onFloor(distance, 0, 1, 1);
            const Point up(-std::cos(angle), 0.2, std::sin(angle)), along(0, 1, 0);
            const Polygon whole = parallelogram(Point(0), along, up);
            double sum = 0.0;
            for (const double i : {0.0, 0.5})
                for (const double j : {0.0, 0.5})
                    sum += exchangeArea(a, parallelogram(i * along + j * up, 0.5 * along, 0.5 * up));
            CHECK(exchangeArea(a, whole) == Approx(sum).epsilon(1e-10));
            CHECK(exchangeArea(whole, a) == Approx(sum).epsilon(1e-10));
            CHECK(sum > 0.0);
        }
}

TEST_CASE("exchange area: a polygon of any shape is the sum of its triangles") {
    const std::vector<Point> arrow = {Point(-1, -1, 2), Point(0, 1, 2), Point(1, -1, 2), Point(0, -0.5, 2)};
    const std::vector<Point> six = {Point(2, 0, 1),  Point(1, 1, 2),   Point(-1, 1, 4),
                                    Point(-2, 0, 5), Point(-1, -1, 4), Point(1, -1, 2)};
    for (const std::vector<Point>& corners : {arrow, six})
        for (const double below : {0.0, 1.0, 10.0, 500.0}) {
            const Polygon floor = onFloor(-0.5, -0.5, 1, 1);
            const auto lifted = [&](std::vector<Point> some) {
                for (Point& corner : some) corner.z += below;
                return Polygon(std::move(some));
            };
            // Turned so that its front looks down.
            const Polygon whole = lifted(corners);
            const Polygon down = whole.normal.z < 0 ? whole : lifted({corners.rbegin(), corners.rend()});
            double sum = 0.0;
            const auto add = [&](std::size_t i, std::size_t j, std::size_t k) {
                sum += exchangeArea(floor, Polygon({down.corners[i], down.corners[j], down.corners[k]}));
            };
            if (down.corners.size() == 6)
                for (const std::size_t i : {1, 2, 3, 4}) add(0, i, i + 1);
            else  // the corner that turns back is the last before turning, the first after
                whole.normal.z < 0 ? (add(3, 0, 1), add(3, 1, 2)) : (add(0, 1, 2), add(0, 2, 3));
            CAPTURE(below);
            CHECK(exchangeArea(floor, down) == Approx(sum).epsilon(1e-10));
        }
}

TEST_CASE("exchange area: neither the place nor the unit of length matters") {
    const Polygon a({Point(0), Point(1, 0, 0), Point(0, 1, 0)});
    const Polygon b({Point(.2, .1, 1), Point(.3, .9, 1.4), Point(1.2, .3, .8)});
    for (const double scale : {1e-6, 1e6})
        CHECK(formFactor(moved(a, scale, 0), moved(b, scale, 0)) == Approx(0.0794017110027708).epsilon(1e-12));
    CHECK(formFactor(moved(a, 1, 1e6), moved(b, 1, 1e6)) == Approx(0.0794017110027708).epsilon(1e-8));
}

TEST_CASE("exchange area: six sides of a box close, whatever its shape") {
    for (const double height : {1e-3, 0.1, 1.0, 10.0, 1e3}) {
        const std::vector<Polygon> sides = boxSides(1, 2, height);
        for (const Polygon& from : sides) {
            double sum = 0.0;
            for (const Polygon& to : sides) sum += formFactor(from, to);
            CAPTURE(height);
            CHECK(sum == Approx(1.0).epsilon(1e-11));
        }
    }
}
