#include "engine/HierarchicalRadiosity.h"

#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include "engine/FormFactors.h"
#include "engine/SceneTestHelp.h"

using namespace radlab;
using namespace radlab::engine;
using doctest::Approx;

namespace {

std::vector<Point> byMatrix(const CutScene& cut, bool occlusion) {
    FormFactorOptions options;
    options.occlusion = occlusion;
    return solveRadiosity(formFactors(cut.geometry, options), cut.surfaces);
}

std::vector<Point> byLinks(const CutScene& cut, double threshold, HierarchicalReport* report = nullptr,
                           bool occlusion = true, double tolerance = 1e-3) {
    HierarchicalOptions options;
    options.threshold = threshold;
    options.occlusion = occlusion;
    options.tolerance = tolerance;
    return solveHierarchical(cut.geometry, cut.surfaces, options, report);
}

}  // namespace

TEST_CASE("with a threshold of 0 the links are all pairs of patches, and the solution is the matrix's") {
    const CutScene cut("cornell_1.x3d", 120.0);
    const std::vector<Point> truth = byMatrix(cut, false);
    HierarchicalReport report;
    const std::vector<Point> found = byLinks(cut, 0.0, &report, false, 1e-6);
    for (std::size_t i = 0; i < truth.size(); ++i)
        for (int c = 0; c < 3; ++c) CHECK(found[i][c] == Approx(truth[i][c]).epsilon(1e-5));
    CHECK(report.rays == 0);
}

TEST_CASE("a smaller threshold takes more links, and comes nearer to the matrix's solution") {
    const CutScene cut("cornell_2.x3d", 60.0);
    const std::vector<Point> truth = byMatrix(cut, true);
    double before = 1.0;
    std::size_t links = 0;
    for (const double threshold : {1e-2, 1e-3, 1e-4, 1e-5}) {
        CAPTURE(threshold);
        HierarchicalReport report;
        const double error = cut.relativeError(byLinks(cut, threshold, &report), truth);
        CHECK(error < before);
        CHECK(report.links > links);
        before = error;
        links = report.links;
    }
    CHECK(before < 3e-3);
}

TEST_CASE("finer patches take no more links where the light does not ask for them") {
    HierarchicalReport coarse, fine;
    byLinks(CutScene("cornell_2.x3d", 40.0), 1e-3, &coarse);
    byLinks(CutScene("cornell_2.x3d", 13.0), 1e-3, &fine);
    CHECK(fine.links < coarse.links + coarse.links / 10);
}

TEST_CASE("the furnace shines as E/(1-rho): within 2 % by two links a patch, within 0.2 % by a hundred") {
    const CutScene cut("furnace.x3d", 0.1);
    const std::vector<Point> truth(cut.geometry.patches.size(), Point(2.0));
    HierarchicalReport few, many;
    CHECK(cut.relativeError(byLinks(cut, 1e-3, &few, false), truth) < 2e-2);
    CHECK(cut.relativeError(byLinks(cut, 1e-5, &many, false), truth) < 2e-3);
    CHECK(few.links < 2 * truth.size());
    CHECK(many.links < 100 * truth.size());
}

TEST_CASE("links give the same bits for any number of threads") {
    const CutScene cut("cornell_2.x3d", 60.0);
    std::vector<std::vector<Point>> found;
    for (const std::size_t threads : {1, 2}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        found.push_back(byLinks(cut, 1e-4));
    }
    CHECK(found[0] == found[1]);
}

TEST_CASE("a scene without light takes no link between patches, and is black") {
    HierarchicalReport report;
    for (const Point& b : byLinks(CutScene("dark.x3d", 0.2), 1e-4, &report)) CHECK(b == Point(0.0));
    CHECK(report.channels == 0);
}

TEST_CASE("scenes of many faces are linked, too") {
    const CutScene cut("teapot.x3d", 1.0);
    const std::vector<Point> found = byLinks(cut, 1e-3);
    for (std::size_t i = 0; i < found.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            CHECK(std::isfinite(found[i][c]));
            CHECK(found[i][c] >= cut.surfaces.emission[i][c]);
        }
}
