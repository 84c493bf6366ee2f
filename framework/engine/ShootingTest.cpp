#include "engine/Shooting.h"

#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include "base/Error.h"
#include "engine/FormFactors.h"
#include "engine/SceneTestHelp.h"
#include "engine/SpecularTransport.h"

using namespace radlab;
using namespace radlab::engine;
using doctest::Approx;

namespace {

struct Shot {
    explicit Shot(const char* scene, double size, ShootingOptions options = {}) : cut(scene, size) {
        FormFactorOptions factors;
        factors.tolerance = 1e-4;
        matrix = std::make_unique<FormFactorMatrix>(formFactors(cut.geometry, factors));
        radiosity = shootRadiosity(matrix->areas(), cut.surfaces, rows(), options, &report);
    }

    RowFunction rows() const {
        return [this](std::size_t shooter, double* factors) {
            std::copy_n(matrix->row(shooter), matrix->size(), factors);
        };
    }

    CutScene cut;
    std::unique_ptr<FormFactorMatrix> matrix;
    ShootingReport report;
    std::vector<Point> radiosity;
};

}  // namespace

TEST_CASE("shooting ends where conjugate gradients end") {
    ShootingOptions options;
    options.unshot = 1e-9;
    const Shot shot("cornell_2.x3d", 90, options);
    const std::vector<Point> solved = solveRadiosity(*shot.matrix, shot.cut.surfaces);
    for (std::size_t i = 0; i < solved.size(); ++i)
        for (int c = 0; c < 3; ++c) CHECK(shot.radiosity[i][c] == Approx(solved[i][c]).epsilon(1e-6));
    CHECK(shot.report.unshot <= 1e-9);
}

TEST_CASE("with a mirror, too, shooting ends where conjugate gradients end, and shots carry what goes over it") {
    const CutScene cut("mirror.x3d", 140);
    SpecularOptions rays;
    rays.rays = 256;
    const SpecularTransport specular(cut.geometry, scatteringsOf(cut.scene), rays);
    const FormFactorMatrix matrix = formFactors(cut.geometry, {});
    Transport transport = transportOf(matrix);
    const std::vector<Point> without = solveRadiosity(transport, cut.surfaces);
    transport.further = specular.further();
    const std::vector<Point> solved = solveRadiosity(transport, cut.surfaces);
    ShootingOptions options;
    options.unshot = 1e-4;
    options.further = [&](std::size_t shooter) { return specular.row(shooter); };
    const RowFunction rows = [&](std::size_t i, double* row) { std::copy_n(matrix.row(i), matrix.size(), row); };
    const std::vector<Point> shot = shootRadiosity(matrix.areas(), cut.surfaces, rows, options);
    CHECK(cut.relativeError(shot, solved) < 1e-4);
    CHECK(cut.relativeError(shot, without) > 0.02);
}

TEST_CASE("what is unshot falls from shot to shot, and the ambient term makes up for most of it") {
    double before = 1.0;
    for (const std::size_t shots : {8, 24, 80, 240}) {
        CAPTURE(shots);
        ShootingOptions options;
        options.mostShots = shots;
        Shot shot("cornell_2.x3d", 90, options);
        CHECK(shot.report.shots == shots);
        CHECK(shot.report.unshot < before);
        before = shot.report.unshot;
        const std::vector<Point> solved = solveRadiosity(*shot.matrix, shot.cut.surfaces);
        const double without = shot.cut.relativeError(shot.radiosity, solved);
        addAmbient(shot.radiosity, shot.cut.surfaces, shot.report.ambient);
        CHECK(shot.cut.relativeError(shot.radiosity, solved) < without);
    }
}

TEST_CASE("a scene without light takes no shot, and the furnace ends at E/(1-rho)") {
    const Shot dark("dark.x3d", 0.5);
    CHECK(dark.report.shots == 0);
    CHECK(dark.report.unshot == 0.0);
    for (const Point& b : dark.radiosity) CHECK(b == Point(0.0));
    ShootingOptions options;
    options.unshot = 1e-8;
    const Shot furnace("furnace.x3d", 0.5, options);
    for (const Point& b : furnace.radiosity) CHECK(b.x == Approx(2.0).epsilon(1e-3));
}

TEST_CASE("shooting gives the same bits for any number of threads") {
    std::vector<std::vector<Point>> found;
    for (const std::size_t threads : {1, 2}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        found.push_back(Shot("cornell_2.x3d", 120).radiosity);
    }
    CHECK(found[0] == found[1]);
}

TEST_CASE("light that grows is told instead of followed for ever") {
    const std::vector<double> areas = {1.0, 1.0};
    const Surfaces surfaces{{Point(1.0), Point(0.0)}, {Point(0.9), Point(0.9)}};
    const RowFunction tooMuch = [](std::size_t shooter, double* factors) {
        factors[shooter] = 0.0;
        factors[1 - shooter] = 1.5;
    };
    CHECK_THROWS_WITH_AS(shootRadiosity(areas, surfaces, tooMuch), doctest::Contains("add up to more than 1"), Error);
}
