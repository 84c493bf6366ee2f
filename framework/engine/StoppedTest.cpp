// What Ctrl-C leaves of long work. It is pressed by the work itself, at the same place every time.

#include <csignal>

#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include "base/Interrupts.h"
#include "engine/FormFactors.h"
#include "engine/HierarchicalRadiosity.h"
#include "engine/PathTracer.h"
#include "engine/Picture.h"
#include "engine/SceneTestHelp.h"
#include "engine/Shooting.h"
#include "engine/SolveToError.h"
#include "engine/SpecularTransport.h"

using namespace radlab;
using namespace radlab::engine;

namespace {

// On one thread, so that no other one is further than the one that presses it.
struct Alone {
    const tbb::global_control thread{tbb::global_control::max_allowed_parallelism, 1};
};

void pressCtrlC() { std::raise(SIGINT); }

// Presses it as soon as so many steps are done.
Progress pressAt(std::size_t steps) {
    return [=](std::size_t done) {
        if (done >= steps && !Interrupts::caught()) pressCtrlC();
    };
}

// The same exchange, that presses it the so-manieth time.
Transport pressingAt(const Transport& transport, int time) {
    return {transport.areas, [&transport, left = std::make_shared<int>(time)](const std::vector<double>& x,
                                                                              std::vector<double>& result) {
                if (--*left == 0) pressCtrlC();
                transport.exchange(x, result);
            }};
}

std::vector<Point> byLinksUntil(const CutScene& cut, std::size_t round, HierarchicalReport& report) {
    const Interrupts interrupts;
    HierarchicalOptions options;
    std::size_t rounds = 0;
    options.progress = [&](std::size_t) {
        if (++rounds == round) pressCtrlC();
    };
    return solveHierarchical(cut.geometry, cut.surfaces, options, &report);
}

AccurateSolution toErrorUntil(const Scene& scene, double error, double tries) {
    const Interrupts interrupts;
    ErrorGoal goal;
    goal.error = error;
    goal.progress = [&](double done, const std::string&) {
        if (done >= tries && !Interrupts::caught()) pressCtrlC();
    };
    return solveToError(scene, findEffects(scene), goal);
}

Frame smallFrame(const Scene& scene) {
    Frame frame;
    frame.camera = scene.cameras.at(0);
    frame.width = 64;
    frame.height = 48;
    return frame;
}

}  // namespace

TEST_CASE_FIXTURE(
    Alone, "Ctrl-C in conjugate gradients leaves the iterations so far of all channels, and says how good they are") {
    const CutScene cut("cornell_2.x3d", 120.0);
    const FormFactorMatrix matrix = formFactors(cut.geometry, {});
    const Transport transport = transportOf(matrix);
    const std::vector<Point> truth = solveRadiosity(transport, cut.surfaces);
    // Two exchanges show that it is reciprocal, one begins each channel, and each iteration takes one.
    double before = 1.0;
    for (const int iterations : {2, 4, 6}) {
        CAPTURE(iterations);
        const Interrupts interrupts;
        SolverReport report;
        const std::vector<Point> found =
            solveRadiosity(pressingAt(transport, 2 + 3 + 3 * iterations + 1), cut.surfaces, {}, &report);
        CHECK(report.stopped);
        CHECK(report.channels == 3);
        CHECK(report.iterations == static_cast<std::size_t>(iterations));
        CHECK(report.residual > SolverOptions().tolerance);
        CHECK(report.residual < 1.0);
        const double error = cut.relativeError(found, truth);
        CHECK(error > 0.0);
        CHECK(error < 3.0 * report.residual);
        CHECK(error < before);
        before = error;
    }
    const Interrupts interrupts;
    CHECK_THROWS_AS(solveRadiosity(pressingAt(transport, 2 + 3 + 1), cut.surfaces), Interrupted);
}

TEST_CASE("a solution that nobody stops says so") {
    const CutScene cut("cornell_2.x3d", 200.0);
    SolverReport solved;
    solveRadiosity(formFactors(cut.geometry, {}), cut.surfaces, {}, &solved);
    CHECK_FALSE(solved.stopped);
    CHECK(solved.residual <= SolverOptions().tolerance);
    HierarchicalReport linked;
    solveHierarchical(cut.geometry, cut.surfaces, {}, &linked);
    CHECK_FALSE(linked.stopped);
}

TEST_CASE_FIXTURE(Alone, "Ctrl-C in links leaves the light of the last round, and nothing in the first") {
    const CutScene cut("cornell_2.x3d", 60.0);
    HierarchicalReport report;
    CHECK_THROWS_AS(byLinksUntil(cut, 1, report), Interrupted);
    const std::vector<Point> truth = solveHierarchical(cut.geometry, cut.surfaces);
    for (const std::size_t round : {2, 3}) {
        CAPTURE(round);
        const std::vector<Point> found = byLinksUntil(cut, round, report);
        CHECK(report.stopped);
        CHECK(report.rounds == round - 1);
        CHECK(report.links > 0);
        CHECK(report.residual <= 1e-2);
        CHECK(cut.relativeError(found, truth) < 0.1);
    }
}

TEST_CASE_FIXTURE(Alone, "Ctrl-C in shooting leaves what was shot, and nothing before the first shots") {
    const CutScene cut("cornell_2.x3d", 120.0);
    const FormFactorMatrix matrix = formFactors(cut.geometry, {});
    const RowFunction rows = [&](std::size_t i, double* row) { std::copy_n(matrix.row(i), matrix.size(), row); };
    ShootingOptions options;
    std::size_t told = 0;
    options.progress = [&](std::size_t shots, double) { pressAt(16)(told = shots); };
    ShootingReport report;
    const Interrupts interrupts;
    shootRadiosity(matrix.areas(), cut.surfaces, rows, options, &report);
    CHECK(report.shots >= 16);
    CHECK(report.shots == told);
    CHECK(report.unshot < 1.0);
    CHECK_THROWS_AS(shootRadiosity(matrix.areas(), cut.surfaces, rows, options, &report), Interrupted);
}

TEST_CASE_FIXTURE(Alone,
                  "Ctrl-C in solving to an error leaves the last try that was finished, with the error of that one") {
    const Scene scene = readX3d(RADLAB_SOURCE_DIR "/resources/scenes/cornell_2.x3d");
    CHECK_THROWS_AS(toErrorUntil(scene, 0.1, 0.2), Interrupted);
    int stopped = 0;
    for (const double error : {0.1, 0.07, 0.05, 0.03, 0.02}) {
        CAPTURE(error);
        const AccurateSolution solution = toErrorUntil(scene, error, 1.0);
        CHECK(solution.stopped != solution.reached);  // by the first try
        CHECK((solution.error > error) == solution.stopped);
        REQUIRE(solution.mesh);
        CHECK(solution.mesh->patches.size() == solution.geometry.patches.size());
        CHECK(solution.radiosity.size() == solution.geometry.patches.size());
        CHECK(solution.surfaces.emission.size() == solution.geometry.patches.size());
        stopped += solution.stopped;
    }
    CHECK(stopped > 0);
}

TEST_CASE_FIXTURE(
    Alone, "Ctrl-C in path tracing leaves fewer paths of every patch and pixel, with standard errors of their own") {
    const CutScene furnace("furnace.x3d", 0.5);
    const TracedScene traced(furnace.geometry, scatteringsOf(furnace.scene));
    const std::size_t patches = furnace.geometry.patches.size(), enough = 32 * 20;
    PathRadiosityOptions options;
    options.samples = 1 << 20;
    options.progress = pressAt(enough * patches);
    {
        const Interrupts interrupts;
        const PathRadiosity found = pathTraceRadiosity(traced, options);
        CHECK(found.samples % 32 == 0);
        CHECK(found.samples >= enough / 2);
        CHECK(found.samples <= enough);
        for (std::size_t i = 0; i < patches; ++i) {
            CHECK(found.standardError[i].x > 0.0);
            CHECK(std::abs(found.radiosity[i].x - 2.0) < 6.0 * found.standardError[i].x);
        }
    }
    {
        const Interrupts interrupts;
        options.progress = pressAt(1);
        CHECK_THROWS_AS(pathTraceRadiosity(traced, options), Interrupted);
    }
    const Interrupts interrupts;
    const Frame frame = smallFrame(furnace.scene);
    const std::size_t pixels = 64 * 48;
    std::size_t fewest = 0;
    const Image image = pathTracePicture(traced, frame, 1 << 20, pressAt(20 * pixels), &fewest);
    CHECK(fewest >= 10);
    CHECK(fewest <= 20);
    for (const glm::vec3& pixel : image.data()) CHECK(pixel.r > 0.0f);
}

TEST_CASE_FIXTURE(Alone,
                  "Ctrl-C in a picture leaves one ray a pixel where more were to come, and nothing before that") {
    const CutScene cut("cornell_2.x3d", 120.0);
    const TracedScene traced(cut.geometry, scatteringsOf(cut.scene));
    const PatchShading shading(solveHierarchical(cut.geometry, cut.surfaces));
    const Frame frame = smallFrame(cut.scene);
    PictureOptions options;
    const Image fine = drawPicture(traced, shading, frame, options);
    options.antialiasing = Antialiasing::off;
    const Image rough = drawPicture(traced, shading, frame, options);
    options.antialiasing = Antialiasing::adaptive;
    PictureReport report;
    {
        const Interrupts interrupts;
        options.progress = pressAt(tilesOf(64, 48) + 1);
        const Image stopped = drawPicture(traced, shading, frame, options, &report);
        CHECK(report.stopped);
        for (std::size_t i = 0; i < stopped.data().size(); ++i)
            CHECK((stopped.data()[i] == rough.data()[i] || stopped.data()[i] == fine.data()[i]));
    }
    const Interrupts interrupts;
    options.progress = pressAt(1);
    CHECK_THROWS_AS(drawPicture(traced, shading, frame, options, &report), Interrupted);
}

TEST_CASE_FIXTURE(Alone, "Ctrl-C in form factors and in light over mirrors ends them, as a part of them is of no use") {
    const CutScene cut("mirror.x3d", 100.0);
    for (const Method method : {Method::visibility, Method::hemisphere, Method::hemicube, Method::polygon}) {
        CAPTURE(nameOf(method));
        const Interrupts interrupts;
        FormFactorOptions options;
        options.method = method;
        options.progress = pressAt(1);
        CHECK_THROWS_AS(formFactors(cut.geometry, options), Interrupted);
    }
    const Interrupts interrupts;
    SpecularOptions options;
    options.progress = pressAt(1);
    CHECK_THROWS_AS(SpecularTransport(cut.geometry, scatteringsOf(cut.scene), options), Interrupted);
}
