#include "engine/PathTracer.h"

#include <cmath>
#include <numbers>
#include <string>

#include <doctest/doctest.h>
#include <tbb/global_control.h>

#include "base/Error.h"
#include "engine/ClosedFormRoom.h"
#include "engine/ExchangeArea.h"
#include "engine/FormFactors.h"
#include "engine/Picture.h"
#include "engine/Radiosity.h"
#include "engine/SceneTestHelp.h"

using namespace radlab;
using namespace radlab::engine;
using doctest::Approx;

namespace {

Scattering grey(double emission, double diffuse, double specular = 0.0, double through = 0.0) {
    Scattering made;
    made.emission = Point(emission);
    made.diffuse = Point(diffuse);
    made.specular = Point(specular);
    made.through = through;
    made.mirror = true;
    return made;
}

PathRadiosity traced(const std::vector<Polygon>& faces, const std::vector<Scattering>& scatterings,
                     const PathRadiosityOptions& options = {}) {
    const Geometry geometry = geometryOfFaces(faces);
    return pathTraceRadiosity(TracedScene(geometry, scatterings), options);
}

PathRadiosityOptions samples(std::size_t count, bool constantPatches = false) {
    PathRadiosityOptions options;
    options.samples = count;
    options.constantPatches = constantPatches;
    return options;
}

// How many standard errors a radiosity is off.
double offBy(const PathRadiosity& found, std::size_t patch, double expected) {
    return std::abs(found.radiosity[patch].g - expected) / found.standardError[patch].g;
}

struct Sample : CutScene {
    using CutScene::CutScene;

    std::vector<Point> solved(std::size_t raysForPair) const {
        FormFactorOptions options;
        options.method = Method::visibility;
        options.rays = raysForPair;
        return solveRadiosity(formFactors(geometry, options), surfaces);
    }

    PathRadiosity traced(const PathRadiosityOptions& options) const {
        return pathTraceRadiosity(TracedScene(geometry, scatteringsOf(scene)), options);
    }
};

// The mean over the area of each face.
std::vector<Point> meanOfFaces(const Geometry& geometry, const std::vector<Point>& values) {
    std::vector<Point> means(geometry.faces.size(), Point(0.0));
    std::vector<double> areas(geometry.faces.size(), 0.0);
    for (std::size_t i = 0; i < values.size(); ++i) {
        means[geometry.faceOf[i]] += geometry.patches[i].area * values[i];
        areas[geometry.faceOf[i]] += geometry.patches[i].area;
    }
    for (std::size_t f = 0; f < means.size(); ++f) means[f] /= areas[f];
    return means;
}

}  // namespace

TEST_CASE("path tracing: in the furnace every patch shines as E/(1-ρ), and the standard error says how nearly") {
    const std::vector<Polygon> box = boxSides(1, 2, 3);
    for (const double reflectance : {0.2, 0.5, 0.9, 0.99}) {
        CAPTURE(reflectance);
        double before = 0.0;
        for (const std::size_t count : {64, 1024}) {
            const PathRadiosity found = traced(box, std::vector<Scattering>(6, grey(3.0, reflectance)), samples(count));
            CHECK(found.samples == count);
            for (std::size_t i = 0; i < 6; ++i) CHECK(offBy(found, i, 3.0 / (1.0 - reflectance)) < 5.0);
            if (before > 0.0) CHECK(found.standardError[0].r < 0.5 * before);
            before = found.standardError[0].r;
        }
    }
}

TEST_CASE("path tracing with constant patches: the cube of six patches has the radiosities of the closed form") {
    std::vector<Scattering> half(6, grey(0.0, 0.5)), high(6, grey(0.0, 0.99));
    half[0] = grey(1.0, 0.0);
    high[0].emission = Point(1.0);
    const PathRadiosity dim = traced(boxSides(1, 1, 1), half, samples(16384, true)),
                        bright = traced(boxSides(1, 1, 1), high, samples(4096, true));
    CHECK(dim.radiosity[0] == Point(1.0));
    CHECK(dim.standardError[0] == Point(0.0));
    CHECK(offBy(dim, 1, 0.166600339499) < 5.0);
    CHECK(offBy(bright, 0, 17.3622704726) < 5.0);
    CHECK(offBy(bright, 1, 16.5274251277) < 5.0);
    for (std::size_t i = 2; i < 6; ++i) {
        CHECK(offBy(dim, i, 0.166683245434) < 5.0);
        CHECK(offBy(bright, i, 16.5275760999) < 5.0);
    }
    CHECK(dim.standardError[1].r < 0.005 * dim.radiosity[1].r);
}

TEST_CASE("path tracing with constant patches agrees with the matrix of form factors on every scene") {
    struct Case {
        const char* name;
        float size;
        double factors;  // the error that shadow rays leave in the form factors
    };
    for (const Case& scene :
         {Case{"furnace.x3d", 0.5f, 0.0}, Case{"grey_room.x3d", 1.2f, 0.002}, Case{"cornell_1.x3d", 140.0f, 0.002},
          Case{"cornell_2.x3d", 200.0f, 0.002}, Case{"l_room.x3d", 1.5f, 0.002}}) {
        CAPTURE(std::string(scene.name));
        const Sample sample(scene.name, scene.size);
        const std::vector<Point> solved = sample.solved(1024);
        const PathRadiosity found = sample.traced(samples(1024, true));
        double squares = 0.0, counted = 0.0;
        for (std::size_t i = 0; i < solved.size(); ++i)
            for (int c = 0; c < 3; ++c) {
                CAPTURE(i);
                const double off = std::abs(found.radiosity[i][c] - solved[i][c]), error = found.standardError[i][c];
                CHECK(off <= 5.0 * error + scene.factors * solved[i][c] + 1e-12);
                if (!(error > 0.0)) continue;
                squares += off * off / (error * error);
                ++counted;
            }
        // The standard errors are what they say, one in the mean, as far as some dozens of patches can tell.
        CHECK(squares / counted > 0.5);
        CHECK(squares / counted < 2.0);
    }
}

TEST_CASE("path tracing gives the light that radiosity tends to as its patches shrink, whatever the patches") {
    const Sample coarse("cornell_2.x3d", 1000.0f), medium("cornell_2.x3d", 120.0f), fine("cornell_2.x3d", 60.0f);
    const PathRadiosity found = coarse.traced(samples(16384));
    const std::vector<Point> means = meanOfFaces(coarse.geometry, found.radiosity),
                             errors = meanOfFaces(coarse.geometry, found.standardError),
                             there = meanOfFaces(medium.geometry, medium.solved(64)),
                             further = meanOfFaces(fine.geometry, fine.solved(64));
    for (std::size_t f = 0; f < means.size(); ++f)
        for (int c = 0; c < 3; ++c) {
            CAPTURE(f);
            // One radiosity a patch leaves an error in proportion to its size.
            const double limit = 2.0 * further[f][c] - there[f][c];
            CHECK(std::abs(means[f][c] - limit) <= 5.0 * errors[f][c] + 0.02 * means[f][c]);
        }
}

TEST_CASE("path tracing: in a box of mirrors that are also matt, what arrives is E/(1-ρ-ks)") {
    const double emission = 2.0, diffuse = 0.3, specular = 0.4, arrives = emission / (1.0 - diffuse - specular);
    const PathRadiosity found =
        traced(boxSides(1, 2, 3), std::vector<Scattering>(6, grey(emission, diffuse, specular)), samples(4096));
    for (std::size_t i = 0; i < 6; ++i) {
        CHECK(offBy(found, i, emission + diffuse * arrives) < 5.0);
        CHECK(found.standardError[i].r < 0.01 * found.radiosity[i].r);
    }
}

TEST_CASE("path tracing: a mirror lights a patch as the virtual image of the lamp would") {
    const double diffuse = 0.5, specular = 0.8;
    const Polygon patch = onFloor(0, 0, 1, 1), lamp = onFloor(2, 0, 1, 1);
    const PathRadiosity found = traced({patch, lamp, onCeiling(-50, -50, 1, 100, 100)},
                                       {grey(0.0, diffuse), grey(1.0, 0.0), grey(0.0, 0.0, specular)}, samples(131072));
    const double toLamp = exchangeArea(patch, onCeiling(2, 0, 2, 1, 1), 1e-9),
                 toItself = exchangeArea(patch, onCeiling(0, 0, 2, 1, 1), 1e-9);
    CHECK(offBy(found, 0, diffuse * specular * toLamp / (1.0 - diffuse * specular * toItself)) < 5.0);
    CHECK(found.standardError[0].r < 0.03 * found.radiosity[0].r);
}

TEST_CASE("path tracing: panes weaken light by what they let through, from either side, and opaque ones stop it") {
    const double factor = 0.199824895698387;
    for (const double through : {0.0, 0.3, 1.0})
        for (const bool turned : {false, true}) {
            CAPTURE(through);
            const Polygon pane = turned ? onFloor(-1, -1, 3, 3) : onCeiling(-1, -1, 0, 3, 3);
            std::vector<Point> low = pane.corners, high = pane.corners;
            for (Point& corner : low) corner.z = 0.3;
            for (Point& corner : high) corner.z = 0.7;
            const PathRadiosity found =
                traced({onFloor(0, 0, 1, 1), onCeiling(0, 0, 1, 1, 1), Polygon(low), Polygon(high)},
                       {grey(0.0, 0.5), grey(1.0, 0.0), grey(0.0, 0.0, 0.0, through), grey(0.0, 0.0, 0.0, through)},
                       samples(4096));
            const double expected = 0.5 * factor * through * through;
            CHECK(std::abs(found.radiosity[0].g - expected) <= 5.0 * found.standardError[0].g);
            CHECK(found.standardError[0].r <= 0.02 * expected);
        }
}

TEST_CASE("a path traced picture shows the furnace and what lies behind panes") {
    Frame frame;
    frame.camera.position = Vec3f(0.5f, 0.5f, 0.9f);
    frame.width = frame.height = 16;
    const Geometry box = geometryOfFaces(boxSides(1, 1, 1));
    const Image furnace = pathTracePicture(TracedScene(box, std::vector<Scattering>(6, grey(1.0, 0.5))), frame, 64);
    double mean = 0.0;
    for (const glm::vec3& pixel : furnace.data()) mean += double(pixel.g) / 256.0;
    CHECK(mean == Approx(2.0 * std::numbers::inv_pi).epsilon(0.01));
    const Geometry window =
        geometryOfFaces({onFloor(-5, -5, 10, 10), parallelogram({-5, -5, 0.5}, {10, 0, 0}, {0, 10, 0})});
    const TracedScene seen(window, {grey(1.0, 0.0), grey(0.0, 0.0, 0.0, 0.5)});
    const Image dimmed = pathTracePicture(seen, frame, 4);
    for (const glm::vec3& pixel : dimmed.data()) CHECK(pixel.g == Approx(0.5 * std::numbers::inv_pi).epsilon(1e-6));
}

TEST_CASE("a lobe, a pane and a mirror look the same gathered and path traced") {
    std::vector<Scattering> scatterings(6, grey(1.0, 0.0));
    scatterings[0] = grey(0.0, 0.0, 0.5, 0.25);
    scatterings[0].mirror = false;
    scatterings[2] = grey(0.0, 0.0, 0.75);
    scatterings[5].emission = Point(20.0, 5.0, 1.0);
    const Geometry box = geometryOfFaces(boxSides(1, 1, 1));
    for (const double exponent : {0.0, 10.0, 100.0}) {
        CAPTURE(exponent);
        scatterings[0].exponent = exponent;
        const TracedScene scene(box, scatterings);
        Frame frame;
        frame.camera.position = Vec3f(0.4f, 0.6f, 0.95f);
        frame.camera.fieldOfView = 1.5f;
        frame.width = frame.height = 8;
        frame.background = Point(4.0);
        std::vector<Point> radiosity;
        for (const Scattering& scattering : scatterings) radiosity.push_back(scattering.emission);
        PictureOptions everywhere;
        everywhere.antialiasing = Antialiasing::everywhere;
        everywhere.samplesPerEdge = 32;
        everywhere.lobeSamples = 1;
        const Image gathered = drawPicture(scene, PatchShading(radiosity), frame, everywhere),
                    walked = pathTracePicture(scene, frame, 4096);
        for (std::size_t i = 0; i < walked.data().size(); ++i)
            for (int c = 0; c < 3; ++c) {
                CAPTURE(i);
                CHECK(gathered.data()[i][c] == Approx(walked.data()[i][c]).epsilon(0.1));
            }
        double there = 0.0, here = 0.0;
        for (std::size_t i = 0; i < walked.data().size(); ++i) {
            there += double(walked.data()[i].r);
            here += double(gathered.data()[i].r);
        }
        CHECK(here == Approx(there).epsilon(0.01));
    }
}

TEST_CASE("light that never ends is refused, and a room without light is black") {
    const std::vector<Polygon> box = boxSides(1, 1, 1);
    CHECK_THROWS_WITH_AS(traced(box, std::vector<Scattering>(6, grey(0.0, 0.5, 0.5)), samples(1)),
                         doctest::Contains("never ends"), Error);
    const PathRadiosity dark = traced(box, std::vector<Scattering>(6, grey(0.0, 0.5)), samples(32));
    for (const Point& b : dark.radiosity) CHECK(b == Point(0.0));
}

TEST_CASE("faces without area take no part in path tracing and pictures") {
    std::vector<Polygon> faces = boxSides(1, 1, 1);
    std::vector<Scattering> scatterings(7, grey(1.0, 0.5));
    faces.push_back(Polygon({Point(0.1, 0.1, 0.5), Point(0.5, 0.5, 0.5), Point(0.9, 0.9, 0.5)}));
    const PathRadiosity found = traced(faces, scatterings, samples(1024));
    CHECK(found.radiosity[6] == Point(1.0));
    for (std::size_t i = 0; i < 6; ++i) CHECK(offBy(found, i, 2.0) < 5.0);
    const Geometry geometry = geometryOfFaces(faces);
    Frame frame;
    frame.camera.position = Vec3f(0.5f, 0.5f, 0.9f);
    frame.width = frame.height = 16;
    const Image image =
        drawPicture(TracedScene(geometry, scatterings), PatchShading(std::vector<Point>(7, Point(2.0))), frame);
    for (const glm::vec3& pixel : image.data()) CHECK(pixel.r == Approx(2.0 * std::numbers::inv_pi).epsilon(1e-6));
}

TEST_CASE("path traced radiosities and pictures are the same to the bit for any number of threads") {
    const Sample sample("mirror.x3d", 200.0f);
    Frame frame;
    frame.camera = sample.scene.cameras[0];
    frame.width = 40;
    frame.height = 30;
    const auto with = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        const TracedScene scene(sample.geometry, scatteringsOf(sample.scene));
        return std::pair(pathTraceRadiosity(scene, samples(64)).standardError,
                         pathTracePicture(scene, frame, 2).data());
    };
    CHECK(with(1) == with(2));
}
