#include "engine/PatchShading.h"

#include <doctest/doctest.h>

#include "engine/LowDiscrepancy.h"
#include "engine/SceneTestHelp.h"
#include "engine/Triangles.h"

using namespace radlab;
using namespace radlab::engine;
using doctest::Approx;

TEST_CASE("corner weights give back the point, on any convex quadrilateral and triangle") {
    const std::vector<Polygon> shapes = {
        Polygon({Point(0, 0, 1), Point(2, 0, 1), Point(2, 3, 1), Point(0, 3, 1)}),
        Polygon({Point(0, 0, 0), Point(4, 0, 4), Point(3, 2, 3), Point(1, 2, 1)}),
        Polygon({Point(0, 0, 0), Point(1, 0.1, 0), Point(5, 6, 0), Point(0, 1, 0)}),
        Polygon({Point(1e-6, 0, 0), Point(1, 0, 0), Point(0, 0, 1), Point(0, 0, 1e-6)}),
        Polygon({Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1)})};
    for (const Polygon& shape : shapes) {
        const AreaSampler sampler(shape);
        const LowDiscrepancy points(1);
        for (std::uint64_t k = 0; k < 500; ++k) {
            const auto at = points.at(k);
            const Point point = sampler.at(at[0], at[1]);
            const auto weights = cornerWeights(shape, point);
            Point back(0.0);
            double sum = 0.0;
            for (std::size_t i = 0; i < shape.corners.size(); ++i) {
                CHECK(weights[i] >= 0.0);
                sum += weights[i];
                back += weights[i] * shape.corners[i];
            }
            CHECK(sum == Approx(1.0).epsilon(1e-14));
            CHECK(glm::length(back - point) < 1e-9 * shape.radius);
        }
    }
}

TEST_CASE(
    "at a corner a smooth face has the mean of the patches that share it, in the middle of a patch that of its "
    "corners") {
    const CutScene furnace("furnace.x3d", 0.5f);
    std::vector<Point> radiosity;
    for (std::size_t i = 0; i < furnace.geometry.patches.size(); ++i) radiosity.emplace_back(double(i % 4), 1.0, 0.0);
    const PatchShading smooth(furnace.mesh, furnace.geometry, radiosity);
    CHECK(smooth.smoothPatches() == radiosity.size());
    // Four patches a face meet in its middle.
    for (std::size_t i = 0; i < radiosity.size(); ++i) {
        const Polygon& face = furnace.geometry.faces[furnace.geometry.faceOf[i]];
        CHECK(smooth.radiosityAt(i, face.center).r == Approx(1.5).epsilon(1e-6));
        CHECK(smooth.radiosityAt(i, furnace.geometry.patches[i].center).g == Approx(1.0).epsilon(1e-12));
    }
    CHECK(PatchShading(radiosity).radiosityAt(3, furnace.geometry.patches[3].corners[0]) == Point(3, 1, 0));
}

TEST_CASE(
    "faces that are one patch are flat, with nothing done for their corners, unless they are parts of a curved "
    "surface") {
    const CutScene furnace("furnace.x3d", 10.0f);
    const std::vector<Point> radiosity(6, Point(1, 2, 3));
    const PatchShading flat(furnace.mesh, furnace.geometry, radiosity);
    CHECK(flat.smoothPatches() == 0);
    CHECK(flat.radiosityAt(4, furnace.geometry.patches[4].corners[1]) == Point(1, 2, 3));
    const CutScene teapot("teapot.x3d", 100.0f);
    const std::vector<Point> same(teapot.geometry.patches.size(), Point(1.0));
    CHECK(PatchShading(teapot.mesh, teapot.geometry, same).smoothPatches() > same.size() / 2);
}
