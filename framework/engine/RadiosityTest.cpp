#include "engine/Radiosity.h"

#include <cmath>

#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include "base/Error.h"
#include "engine/ClosedFormRoom.h"
#include "engine/FormFactors.h"

using namespace radlab;
using namespace radlab::engine;
using doctest::Approx;

namespace {

FormFactorMatrix exactMatrix(const std::vector<Polygon>& patches) {
    FormFactorOptions options;
    options.method = Method::exact;
    options.tolerance = 1e-12;
    return formFactors(geometryOfFaces(patches), options);
}

// Every side of a box in count x count squares.
std::vector<Polygon> finerBox(int count) { return cut(boxSides(1, 1, 1), count).patches; }

Surfaces grey(std::size_t count, double emission, double reflectance) {
    return {std::vector<Point>(count, Point(emission)), std::vector<Point>(count, Point(reflectance))};
}

// The floor of a cube emits 1 and reflects nothing.
Surfaces litFloor(double reflectance) {
    Surfaces surfaces = grey(6, 0.0, reflectance);
    surfaces.emission[0] = Point(1.0);
    surfaces.reflectance[0] = Point(0.0);
    return surfaces;
}

}  // namespace

TEST_CASE("the cube of six patches has the radiosities of the closed form") {
    const FormFactorMatrix matrix = exactMatrix(boxSides(1, 1, 1));
    const std::vector<Point> half = solveRadiosity(matrix, litFloor(0.5));
    CHECK(half[0].x == Approx(1.0).epsilon(1e-13));
    CHECK(half[1].x == Approx(0.166600339499).epsilon(1e-9));
    for (const int side : {2, 3, 4, 5}) CHECK(half[std::size_t(side)].x == Approx(0.166683245434).epsilon(1e-9));
    Surfaces bright = grey(6, 0.0, 0.99);
    bright.emission[0] = Point(1.0);
    const std::vector<Point> high = solveRadiosity(matrix, bright);
    CHECK(high[0].x == Approx(17.3622704726).epsilon(1e-9));
    CHECK(high[1].x == Approx(16.5274251277).epsilon(1e-9));
    CHECK(high[2].x == Approx(16.5275760999).epsilon(1e-9));
}

TEST_CASE("in a furnace every patch shines as E/(1-ρ), up to reflectances of one less a millionth") {
    const FormFactorMatrix matrix = exactMatrix(finerBox(3));
    for (const double reflectance : {0.0, 0.5, 0.9, 0.99, 0.999, 1.0 - 1e-6}) {
        CAPTURE(reflectance);
        SolverReport report;
        const std::vector<Point> radiosity = solveRadiosity(matrix, grey(54, 1.0, reflectance), {}, &report);
        for (const Point& b : radiosity)
            CHECK(b.y * (1.0 - reflectance) == Approx(1.0).epsilon(1e-11 / (1.0 - reflectance) + 1e-9));
        CHECK(report.channels == 1);
    }
}

TEST_CASE("a reflectance of 1 in a closed scene is refused with the patch, and in an open one it is not") {
    CHECK_THROWS_WITH_AS(solveRadiosity(exactMatrix(finerBox(2)), grey(24, 1.0, 1.0)),
                         doctest::Contains("expected less than 1"), Error);
    const std::vector<Polygon> open = {onFloor(0, 0, 1, 1), onCeiling(0, 0, 1, 1, 1)};
    const double factor = 0.199824895698387;
    for (const Point& b : solveRadiosity(exactMatrix(open), grey(2, 1.0, 1.0)))
        CHECK(b.x == Approx(1.0 / (1.0 - factor)).epsilon(1e-9));
}

TEST_CASE("at a reflectance of 0.99 some fifteen iterations do") {
    const std::vector<Polygon> patches = finerBox(6);
    const FormFactorMatrix matrix = exactMatrix(patches);
    Surfaces surfaces = grey(patches.size(), 0.0, 0.99);
    surfaces.emission[200] = Point(1.0);
    SolverOptions options;
    options.tolerance = 1e-6;
    SolverReport report;
    solveRadiosity(matrix, surfaces, options, &report);
    CHECK(report.iterations <= 15);
}

TEST_CASE("what the lamps send out is what the surfaces swallow, at any brightness") {
    const std::vector<Polygon> patches = finerBox(4);
    const FormFactorMatrix matrix = exactMatrix(patches);
    Surfaces surfaces = grey(patches.size(), 0.0, 0.0);
    for (std::size_t i = 0; i < patches.size(); ++i) {
        surfaces.reflectance[i] = Point(0.2 + 0.007 * double(i), i % 3 ? 0.6 : 0.0, 0.95);
        surfaces.emission[i] = Point(i % 7 ? 0.0 : 1.0, std::pow(10.0, double(i % 13) - 6.0), 1e-6);
    }
    const std::vector<Point> radiosity = solveRadiosity(matrix, surfaces);
    for (int c = 0; c < 3; ++c) {
        double sent = 0.0, swallowed = 0.0;
        for (std::size_t i = 0; i < patches.size(); ++i) {
            const double reflectance = surfaces.reflectance[i][c], emission = surfaces.emission[i][c];
            CHECK(radiosity[i][c] >= emission);
            double arriving = 0.0;
            for (std::size_t j = 0; j < patches.size(); ++j) arriving += matrix.at(i, j) * radiosity[j][c];
            sent += patches[i].area * emission;
            swallowed += patches[i].area * (1.0 - reflectance) * arriving;
        }
        CHECK(swallowed == Approx(sent).epsilon(1e-8));
    }
}

TEST_CASE("only the channels that carry light of their own are solved") {
    const FormFactorMatrix matrix = exactMatrix(boxSides(1, 1, 1));
    const auto channels = [&](const Point& emission, const Point& reflectance) {
        Surfaces surfaces = grey(6, 0.0, 0.0);
        for (Point& r : surfaces.reflectance) r = reflectance;
        surfaces.emission[2] = emission;
        SolverReport report;
        const std::vector<Point> radiosity = solveRadiosity(matrix, surfaces, {}, &report);
        for (int c = 0; c < 3; ++c) {
            Surfaces alone = surfaces;
            for (Point& e : alone.emission) e = Point(e[c], 0, 0);
            for (Point& r : alone.reflectance) r = Point(r[c]);
            for (std::size_t i = 0; i < 6; ++i)
                CHECK(radiosity[i][c] == Approx(solveRadiosity(matrix, alone)[i].x).epsilon(1e-12));
        }
        return report.channels;
    };
    CHECK(channels(Point(0.0), Point(0.5)) == 0);
    CHECK(channels(Point(1.0), Point(0.5)) == 1);
    CHECK(channels(Point(4.0, 2.0, 1.0), Point(0.5)) == 1);
    CHECK(channels(Point(4.0, 0.0, 1.0), Point(0.5)) == 1);
    CHECK(channels(Point(1.0), Point(0.5, 0.6, 0.5)) == 2);
    CHECK(channels(Point(1.0), Point(0.5, 0.6, 0.7)) == 3);
}

TEST_CASE("channels that need not be solved come out the same where they are, and one can stand for all") {
    const FormFactorMatrix matrix = exactMatrix(finerBox(2));
    Surfaces surfaces = grey(24, 0.0, 0.8);
    surfaces.emission[7] = Point(1.0, 2.0, 0.0);
    SolverOptions options;
    SolverReport report;
    const std::vector<Point> fewest = solveRadiosity(matrix, surfaces, options, &report);
    CHECK(report.channels == 1);
    options.channels = Channels{{0, 1, 2}, {1.0, 1.0, 1.0}};
    const std::vector<Point> all = solveRadiosity(matrix, surfaces, options, &report);
    CHECK(report.channels == 3);
    options.channels = Channels{{1, 1, 1}, {1.0, 1.0, 1.0}};
    const std::vector<Point> one = solveRadiosity(matrix, surfaces, options, &report);
    CHECK(report.channels == 1);
    for (std::size_t i = 0; i < all.size(); ++i) {
        CHECK(glm::length(all[i] - fewest[i]) <= 1e-9 * glm::length(fewest[i]));
        CHECK(glm::length(one[i] - Point(all[i].y)) <= 1e-9 * all[i].y);
    }
}

TEST_CASE("the radiosities are the same to the bit for any number of threads, and for no patches there are none") {
    const FormFactorMatrix matrix = exactMatrix(finerBox(5));
    Surfaces surfaces = grey(150, 0.0, 0.8);
    surfaces.emission[7] = Point(1.0, 2.0, 0.0);
    const auto with = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return solveRadiosity(matrix, surfaces);
    };
    CHECK(with(1) == with(4));
    CHECK(solveRadiosity(exactMatrix({}), {}).empty());
}

TEST_CASE("a matrix that is not reciprocal is refused, and can be made so") {
    FormFactorOptions options;
    options.method = Method::polygon;
    FormFactorMatrix matrix = formFactors(geometryOfFaces(boxSides(1, 2, 3)), options);
    CHECK_THROWS_WITH_AS(solveRadiosity(matrix, litFloor(0.5)), doctest::Contains("not reciprocal"), Error);
    makeReciprocal(matrix);
    const std::vector<Point> radiosity = solveRadiosity(matrix, litFloor(0.5));
    CHECK(radiosity[1].x > 0.0);
}

TEST_CASE("without indirect light every patch has its emission and what it reflects of the others' emission") {
    const FormFactorMatrix matrix = exactMatrix(finerBox(3));
    Surfaces surfaces = grey(54, 0.0, 0.7);
    surfaces.emission[5] = Point(3.0);
    SolverOptions options;
    options.indirect = false;
    SolverReport report;
    const std::vector<Point> direct = solveRadiosity(matrix, surfaces, options, &report);
    for (std::size_t i = 0; i < 54; ++i)
        CHECK(direct[i].x == Approx(surfaces.emission[i].x + 0.7 * matrix.at(i, 5) * 3.0).epsilon(1e-12));
    CHECK(report.iterations == 0);
}
