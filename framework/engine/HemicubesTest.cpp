#include "engine/Hemicubes.h"

#include <cmath>
#include <numeric>

#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include "base/Error.h"
#include "engine/ClosedFormRoom.h"
#include "engine/HardCases.h"
#include "engine/PointFormFactor.h"
#include "scene/X3dReader.h"

using namespace radlab;
using namespace radlab::engine;
using doctest::Approx;

namespace {

std::vector<double> rowOf(const std::vector<Polygon>& patches, std::size_t shooter, int size,
                          Simd simd = widestSimd()) {
    std::vector<double> factors(patches.size(), -1.0);
    Hemicubes(patches, size, simd).row(shooter, factors.data());
    return factors;
}

double sumOf(const std::vector<double>& factors) { return std::accumulate(factors.begin(), factors.end(), 0.0); }

Geometry cornellBox(float patchSize) {
    const Scene scene = readX3d(RADLAB_SOURCE_DIR "/resources/scenes/cornell_2.x3d");
    return geometryOf(scene, PatchMesh(scene.vertices, scene.faces, patchSize, patchSize));
}

// An edge puts pixels on the wrong side of it by at most half their width, all along a line over the hemicube: half a
// pixel's width there sees .41/size by the top face and twice .08/size by the sides.
double resolution(std::size_t edges, int size) { return 0.6 * static_cast<double>(edges) / size; }

}  // namespace

TEST_CASE("hemicube: rows of a closed room add up to 1") {
    for (const int size : {8, 50, 256}) {
        const std::vector<Polygon> room = boxSides(1, 2, 3);
        for (std::size_t i = 0; i < room.size(); ++i) CHECK(sumOf(rowOf(room, i, size)) == Approx(1.0).epsilon(1e-12));
    }
}

TEST_CASE("hemicube: an open patch sees what its centre sees, within the pixels' resolution, ever better") {
    const Polygon floor = onFloor(0, 0, 1, 1);
    for (const Polygon& other : {onCeiling(0, 0, 1, 1, 1), onCeiling(-.3, .1, .2, 2, 3), onWall(-1, -1, 2, 3),
                                 onWall(.2, .3, .1, 2), parallelogram({-2, -1, 3}, {1, 4, -4}, {5, 1, -3}),
                                 Polygon({Point(0, 0, 2), Point(3, 3, -1), Point(4, 0, 2)})}) {
        const double truth = pointToPolygon(floor.center, floor.normal, other);
        REQUIRE(truth > 0.0);
        for (const int size : {8, 32, 128, 512, 1024})
            CHECK(std::abs(rowOf({floor, other}, 0, size)[1] - truth) <= resolution(4, size));
    }
}

TEST_CASE("hemicube: in every hard case with nothing between, a patch sees what its centre sees") {
    for (const HardCase& hard : hardCases()) {
        if (hard.hidden) continue;
        CAPTURE(hard.what);
        const std::vector<Polygon>& patches = hard.geometry.patches;
        const double truth = pointToPolygon(patches[0].center, patches[0].normal, patches[1]);
        const double found = formFactorOf(hard, Method::hemicube, 0);
        CHECK(std::abs(found - truth) <= resolution(4, 256));
        if (truth == 0.0) CHECK(found == 0.0);
    }
}

TEST_CASE("hemicube: what hides part of a plate hides it for the centre; small patches give the closed form of all") {
    const Polygon floor = onFloor(0, 0, 1, 1), ceiling = onCeiling(0, 0, 1, 1, 1);
    const Polygon plate = onCeiling(0, 0, 0.5, 0.5, 0.5);
    const double open = pointToPolygon(floor.center, floor.normal, ceiling);
    CHECK(std::abs(rowOf({floor, ceiling, plate}, 0, 512)[1] - 0.75 * open) <= resolution(4, 512));
    constexpr int cuts = 8;
    std::vector<Polygon> patches = {ceiling, plate};
    for (int i = 0; i < cuts * cuts; ++i)
        patches.push_back(onFloor(double(i / cuts) / cuts, double(i % cuts) / cuts, 1.0 / cuts, 1.0 / cuts));
    double mean = 0.0;
    for (std::size_t i = 2; i < patches.size(); ++i) mean += rowOf(patches, i, 256)[0] / (cuts * cuts);
    CHECK(mean == Approx(0.149868671773790).epsilon(5e-3));
}

TEST_CASE("hemicube: the back of a patch hides and receives nothing") {
    const Polygon floor = onFloor(0, 0, 1, 1), ceiling = onCeiling(-4, -4, 2, 9, 9);
    const Polygon back = onFloor(-4, -4, 1, 9);
    const std::vector<double> row =
        rowOf({floor, ceiling, parallelogram({-8, -8, 1}, {17, 0, 0}, {0, 17, 0}), back}, 0, 64);
    CHECK(row[2] == 0.0);
    CHECK(row[1] < 0.01);
}

TEST_CASE("hemicube: a real scene gives the same bits with every width of instructions and any number of threads") {
    const Geometry box = cornellBox(60.0f);
    for (std::size_t i = 0; i < box.patches.size(); i += 37) {
        const std::vector<double> plain = rowOf(box.patches, i, 64, Simd::plain);
        CHECK(plain == rowOf(box.patches, i, 64, widestSimd()));
        CHECK(plain == rowOf(box.patches, i, 64, std::min(widestSimd(), Simd::avx2)));
        CHECK(sumOf(plain) <= 1.0 + 1e-12);
    }
    FormFactorOptions options;
    options.method = Method::hemicube;
    options.hemicubeSize = 32;
    const FormFactorMatrix all = formFactors(box, options);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const FormFactorMatrix alone = formFactors(box, options);
    for (std::size_t i = 0; i < all.size(); ++i) REQUIRE(std::equal(all.row(i), all.row(i) + all.size(), alone.row(i)));
}

TEST_CASE("hemicube: patches without area and scenes of any scale and place break nothing") {
    std::vector<Polygon> room = boxSides(1, 1, 1);
    room.push_back(Polygon({Point(.5, .5, .2), Point(.6, .5, .2), Point(.7, .5, .2)}));
    room.push_back(Polygon({Point(.5, .5, .5), Point(.5, .5, .5), Point(.5, .5, .5)}));
    CHECK(sumOf(rowOf(room, 6, 32)) == 0.0);
    CHECK(sumOf(rowOf(room, 7, 32)) == 0.0);
    const std::vector<double> row = rowOf(room, 0, 32);
    CHECK(row[6] == 0.0);
    for (const double scale : {1e-6, 1e6})
        for (const double offset : {0.0, 1e6}) {
            if (scale * 1e6 < offset) continue;
            std::vector<Polygon> moved;
            for (const Polygon& side : boxSides(scale, scale, scale)) {
                std::vector<Point> corners = side.corners;
                for (Point& corner : corners) corner += Point(offset);
                moved.emplace_back(corners);
            }
            const std::vector<double> found = rowOf(moved, 0, 32);
            CHECK(sumOf(found) == Approx(1.0).epsilon(1e-12));
            for (std::size_t j = 1; j < 6; ++j) CHECK(found[j] == Approx(row[j]).epsilon(0.02));
        }
}

TEST_CASE("hemicube: a size that is odd or out of range is refused") {
    const std::vector<Polygon> room = boxSides(1, 1, 1);
    for (const int size : {-2, 0, 6, 9, 4098})
        CHECK_THROWS_WITH_AS(Hemicubes(room, size), doctest::Contains("expected an even number from 8 to 4096"), Error);
}
