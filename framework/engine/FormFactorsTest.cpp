#include "engine/FormFactors.h"

#include <cmath>

#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include "base/Error.h"
#include "engine/ClosedFormRoom.h"
#include "engine/ExchangeArea.h"
#include "engine/FormFactorRows.h"
#include "engine/PointFormFactor.h"
#include "engine/SceneTestHelp.h"

using namespace radlab;
using namespace radlab::engine;
using doctest::Approx;

namespace {

FormFactorMatrix matrixOf(const Geometry& geometry, Method method, std::size_t rays = 0,
                          FormFactorReport* report = nullptr) {
    FormFactorOptions options;
    options.method = method;
    options.rays = rays;
    options.tolerance = 1e-12;
    return formFactors(geometry, options, report);
}

// Unit squares at distance 1, and something between them.
Geometry platesWith(const Polygon& blocker, const Polygon& back) {
    return geometryOfFaces({onFloor(0, 0, 1, 1), onCeiling(0, 0, 1, 1, 1), blocker, back});
}

constexpr double quarterHidden = 0.149868671773790;  // closed form; a quarter at half the height, over a corner

Geometry quarterHiddenPlates() {
    return platesWith(onCeiling(0, 0, 0.5, 0.5, 0.5), parallelogram({0, 0, 0.5}, {0.5, 0, 0}, {0, 0.5, 0}));
}

}  // namespace

TEST_CASE("a point sees corners of rectangles as the closed form says") {
    CHECK(pointToPolygon(Point(0), Point(0, 0, 1), onCeiling(0, 0, 1, 1, 1)) ==
          Approx(0.138531605994893).epsilon(1e-13));
    CHECK(pointToPolygon(Point(1, 0, 0), Point(0, 0, 1), onWall(0, 0, 1, 1)) ==
          Approx(0.055734197002554).epsilon(1e-12));
}

TEST_CASE("a point sees the same of a polygon near and far, by its outline and by nodes") {
    for (const double distance : {1.0, 140.0, 142.0, 1e4, 1e6}) {
        const Polygon ceiling = onCeiling(-0.5, -0.5, distance, 1, 1);
        const double angle = 0.5 / distance, root = std::sqrt(1 + angle * angle);
        const double truth = 4.0 / 3.14159265358979323846 * angle / root * std::atan(angle / root);
        CAPTURE(distance);
        CHECK(pointToPolygon(Point(0), Point(0, 0, 1), ceiling) == Approx(truth).epsilon(1e-11));
    }
}

TEST_CASE("a point sees nothing of what lies in its plane, behind it, or turned away") {
    CHECK(pointToPolygon(Point(0), Point(0, 0, 1), onFloor(0, 0, 1, 1)) == 0.0);
    CHECK(pointToPolygon(Point(.5, .5, 0), Point(0, 0, 1), onCeiling(0, 0, 0, 1, 1)) == 0.0);
    CHECK(pointToPolygon(Point(0), Point(0, 0, 1), onCeiling(0, 0, -1, 1, 1)) == 0.0);
    CHECK(pointToPolygon(Point(0, 0, 2), Point(0, 0, -1), onCeiling(0, 0, 1, 1, 1)) == 0.0);
    CHECK(pointToPolygon(Point(0, .5, .5), Point(0, 0, 1), onWall(0, 0, 1, 1)) == 0.0);
}

TEST_CASE("from a millionth in front of a corner of a room the polygons are seen whole") {
    double sum = 0.0;
    const Point eye(1e-6, 1e-6, 0);
    for (const Polygon& side : boxSides(1, 1, 1)) sum += pointToPolygon(eye, Point(0, 0, 1), side);
    CHECK(sum == Approx(1.0).epsilon(1e-12));
}

TEST_CASE("the matrix of a closed box keeps both laws by every method, within the method's error") {
    const Geometry box = geometryOfFaces(boxSides(1, 2, 3));
    const MatrixQuality exact = qualityOf(matrixOf(box, Method::exact));
    CHECK(exact.lowestSum == Approx(1.0).epsilon(1e-12));
    CHECK(exact.highestSum == Approx(1.0).epsilon(1e-12));
    CHECK(exact.reciprocity < 1e-15);
    const MatrixQuality rays = qualityOf(matrixOf(box, Method::hemisphere, 16384));
    CHECK(rays.lowestSum == Approx(1.0).epsilon(1e-3));
    CHECK(rays.highestSum <= 1.0);
    CHECK(qualityOf(matrixOf(box, Method::polygon)).highestSum == Approx(1.0).epsilon(1e-12));
}

TEST_CASE("in a convex scene no ray is traced, and visibility is exact to the bit") {
    const Geometry box = geometryOfFaces(boxSides(1, 1, 1));
    FormFactorReport report;
    const FormFactorMatrix exact = matrixOf(box, Method::exact),
                           visible = matrixOf(box, Method::visibility, 0, &report);
    CHECK(report.rays == 0);
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) CHECK(exact.at(i, j) == visible.at(i, j));
    FormFactorOptions options;
    options.occlusion = false;
    formFactors(box, options, &report);
    CHECK(report.method == Method::exact);
    options.occlusion = true;
    formFactors(box, options, &report);
    CHECK(report.method == Method::visibility);
}

TEST_CASE("a quarter that is hidden, and a shadow that the other plate holds, match the closed form") {
    for (const std::size_t rays : {256, 4096, 65536}) {
        CAPTURE(rays);
        const double error = 0.3 / static_cast<double>(rays) + 0.4 / static_cast<double>(rays) * std::sqrt(rays);
        CHECK(matrixOf(quarterHiddenPlates(), Method::visibility, rays).at(0, 1) ==
              Approx(quarterHidden).epsilon(error));
        CHECK(matrixOf(quarterHiddenPlates(), Method::hemisphere, rays).at(0, 1) ==
              Approx(quarterHidden).epsilon(3 * error));
    }
    const double gap = 1.0001;
    const Geometry contained =
        geometryOfFaces({onFloor(-1, -1, 2, 2), onCeiling(-1, -1, gap, 2, 2), onCeiling(-.45, -.45, .75, .9, .9),
                         parallelogram({-.45, -.45, .75}, {.9, 0, 0}, {0, .9, 0})});
    CHECK(matrixOf(contained, Method::visibility, 65536).at(0, 1) == Approx(0.28285406835).epsilon(2e-3));
}

TEST_CASE("a wall between two plates hides all, and one beside or edge-on hides nothing") {
    const auto between = [](const Polygon& blocker) {
        return matrixOf(platesWith(blocker, blocker), Method::visibility).at(0, 1) / 0.199824895698387;
    };
    CHECK(between(onCeiling(-2, -2, 0.5, 5, 5)) == 0.0);
    CHECK(between(onCeiling(3, 3, 0.5, 1, 1)) == Approx(1.0).epsilon(1e-12));
    CHECK(between(onCeiling(-5, -5, 0, 10, 10)) == Approx(1.0).epsilon(1e-12));
    CHECK(between(onWall(-1, 0, 4, 1)) == Approx(1.0).epsilon(1e-12));
}

TEST_CASE("the number of threads changes nothing, not a bit") {
    const Geometry geometry = quarterHiddenPlates();
    for (const Method method : {Method::visibility, Method::hemisphere, Method::exact}) {
        const auto with = [&](std::size_t threads) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
            return matrixOf(geometry, method);
        };
        const FormFactorMatrix alone = with(1), together = with(4);
        for (std::size_t i = 0; i < alone.size(); ++i)
            for (std::size_t j = 0; j < alone.size(); ++j) CHECK(alone.at(i, j) == together.at(i, j));
    }
}

TEST_CASE("enforcing both laws mends a closed matrix without moving it far, and keeps an open one open") {
    FormFactorMatrix rough = matrixOf(geometryOfFaces(boxSides(1, 2, 3)), Method::polygon);
    const FormFactorMatrix truth = matrixOf(geometryOfFaces(boxSides(1, 2, 3)), Method::exact);
    CHECK(qualityOf(rough).reciprocity > 1e-3);
    CHECK(enforceLaws(rough) < 1e-12);
    const MatrixQuality mended = qualityOf(rough);
    CHECK(mended.reciprocity < 1e-14);
    CHECK(mended.lowestSum == Approx(1.0).epsilon(1e-11));
    CHECK(mended.highestSum == Approx(1.0).epsilon(1e-11));
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) CHECK(std::abs(rough.at(i, j) - truth.at(i, j)) < 0.1);
    FormFactorMatrix open = matrixOf(quarterHiddenPlates(), Method::exact);
    CHECK(enforceLaws(open) < 1e-12);
    CHECK(open.at(0, 1) == Approx(0.199824895698387).epsilon(1e-12));
}

TEST_CASE("patches without area exchange nothing and break nothing") {
    std::vector<Polygon> sides = boxSides(1, 1, 1);
    sides.push_back(Polygon({Point(.5, .5, .2), Point(.6, .5, .2), Point(.7, .5, .2)}));
    sides.push_back(Polygon({Point(.5, .5, .5), Point(.5, .5, .5), Point(.5, .5, .5)}));
    for (const Method method :
         {Method::point, Method::polygon, Method::exact, Method::hemicube, Method::hemisphere, Method::visibility}) {
        CAPTURE(nameOf(method));
        const FormFactorMatrix matrix = matrixOf(geometryOfFaces(sides), method);
        for (std::size_t i = 0; i < matrix.size(); ++i)
            for (std::size_t j = 0; j < matrix.size(); ++j) {
                CHECK(std::isfinite(matrix.at(i, j)));
                CHECK(matrix.at(i, j) >= 0.0);
                if (i >= 6 || j >= 6) CHECK(matrix.at(i, j) == 0.0);
            }
    }
}

TEST_CASE("methods have names, and an unknown one is told those that there are") {
    for (const char* name : {"point", "polygon", "exact", "hemicube", "hemisphere", "visibility", "auto"})
        CHECK(nameOf(methodNamed(name)) == name);
    CHECK_THROWS_WITH_AS(methodNamed("exakt"), doctest::Contains("'exakt', expected one of point, polygon"), Error);
}

TEST_CASE("a coarser tolerance is kept, pair by pair") {
    const std::vector<Polygon> patches = cut(boxSides(1, 2, 1.5), 5, 7).patches;
    const ExchangeAreas truth(patches, finestTolerance);
    for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-9}) {
        const ExchangeAreas rough(patches, tolerance);
        double worst = 0.0;
        for (std::size_t i = 0; i < patches.size(); ++i)
            for (std::size_t j = i + 1; j < patches.size(); ++j)
                if (truth(i, j) > 0.0) worst = std::max(worst, std::abs(rough(i, j) / truth(i, j) - 1.0));
        CAPTURE(tolerance);
        CHECK(worst <= tolerance);
        CHECK(worst > 0.0);
    }
}

TEST_CASE("rows on demand are those of the matrix, to the bit, by every method") {
    const CutScene cut("cornell_2.x3d", 150.0);
    for (const Method method : {Method::point, Method::polygon, Method::exact, Method::hemicube, Method::hemisphere,
                                Method::visibility, Method::automatic}) {
        CAPTURE(nameOf(method));
        FormFactorOptions options;
        options.method = method;
        options.rays = 64;
        options.hemicubeSize = 32;
        const FormFactorMatrix matrix = formFactors(cut.geometry, options);
        const FormFactorRows rows(cut.geometry, options);
        std::vector<double> row(matrix.size(), -1.0);
        for (std::size_t i = 0; i < matrix.size(); i += 7) {
            rows.row(i, row.data());
            for (std::size_t j = 0; j < matrix.size(); ++j) CHECK(row[j] == matrix.at(i, j));
        }
    }
}
