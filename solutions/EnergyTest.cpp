#include <limits>

#include <doctest/doctest.h>

#include "TestPatches.h"
#include "base/Error.h"
#include "base/Stopwatch.h"
#include "course/ProgRef.h"
#include "gl/Context.h"
#include "solver/Progressive.h"

using namespace radlab;
using namespace radlab::test;
using doctest::Approx;

namespace {

// The rows of a mesh by calcFF, each made when its patch first shoots and kept for its later shots.
class KeptRows {
public:
    explicit KeptRows(int hemicubeSize) : hemicube(hemicubeSize) {}

    MyPolygon* operator()() {
        MyPolygon* shooter = maxenergy_patch();
        if (!shooter) return nullptr;
        rows.resize(polygons.size());
        std::vector<float>& row = rows[static_cast<std::size_t>(shooter - polygons[0])];
        if (row.empty()) {
            calcFF(&hemicube);
            for (const MyPolygon* patch : polygons) row.push_back(patch->formF);
        }
        for (std::size_t i = 0; i < row.size(); ++i) polygons[i]->formF = row[i];
        return shooter;
    }

private:
    Hemicube hemicube;
    std::vector<std::vector<float>> rows;
};

Faces cube(const Vec3f& diffuse, const Vec3f& emissive) {
    Faces faces;
    faces.addRoom(Vec3f(0), Vec3f(1), material(diffuse, emissive));
    return faces;
}

// A cube with one shining wall.
Faces lamp(const Vec3f& diffuse = Vec3f(0.5f)) {
    Faces faces = cube(diffuse, Vec3f(0.0f));
    faces.faces[1].material = material(diffuse, Vec3f(1.0f));
    return faces;
}

// Rows that need no hemicube: every other patch gets its share by area.
MyPolygon* byArea() {
    MyPolygon* shooter = maxenergy_patch();
    if (!shooter) return nullptr;
    float area = 0.0f;
    for (const MyPolygon* patch : polygons) area += patch == shooter ? 0.0f : patch->area;
    for (MyPolygon* patch : polygons) patch->formF = patch == shooter ? 0.0f : patch->area / area;
    return shooter;
}

}  // namespace

TEST_CASE("the brightest patch is the one with the most unshot power, radiosity times area") {
    const auto mesh = scattered(3, 1);
    for (MyPolygon* patch : polygons) {
        patch->area = 1.0f;
        patch->unshot_rad = Vec3f(1.0f);
    }
    polygons[1]->area = 3.0f;
    polygons[2]->unshot_rad = Vec3f(2.0f);
    CHECK(maxenergy_patch() == polygons[1]);
    polygons[1]->area = 1.9f;
    CHECK(maxenergy_patch() == polygons[2]);
    polygons[2]->area = 0.5f;
    CHECK(maxenergy_patch() == polygons[1]);
}

TEST_CASE("white furnace: in a closed cube that shines all over, every radiosity is E / (1 - rho)") {
    const auto context = GlContext::offscreen();
    const auto mesh = cube(Vec3f(0.5f), Vec3f(1.0f)).mesh(1.0f / 16.0f);
    REQUIRE(mesh->patches.size() == 1536);
    KeptRows rows(512);
    const Stopwatch watch;
    Progressive solver(*mesh, [&] { return rows(); });
    const Progress& progress = solver.run({1000000, 1e-4});
    double mean = 0.0, area = 0.0, worst = 0.0;
    for (const MyPolygon& patch : mesh->patches) {
        mean += double(patch.rad.g) * double(patch.area);
        area += double(patch.area);
        worst = std::max(worst, std::abs(double(patch.rad.g) / 2.0 - 1.0));
    }
    mean /= area;
    MESSAGE("white furnace: mean " << mean << ", worst patch off by " << 100 * worst << " %, " << progress.shots
                                   << " shots, " << watch.seconds() << " s");
    CHECK(progress.unshotShare <= 1e-4);
    CHECK(mean == Approx(2.0).epsilon(0.002));
    CHECK(worst < 0.03);
}

TEST_CASE("solver: it stops at the number of shots") {
    const auto mesh = lamp().mesh(0.25f);
    Progressive solver(*mesh, byArea);
    CHECK(solver.run({7, 0.0}).shots == 7);
    CHECK(solver.run({7, 0.0}).shots == 7);
    CHECK(solver.run({9, 0.0}).shots == 9);  // goes on where it stopped
    CHECK(Progressive(*mesh, byArea).run({0, 0.0}).shots == 0);
}

TEST_CASE("solver: it stops after the first shot that brings the unshot share to the limit") {
    const auto mesh = lamp().mesh(0.25f);
    Progressive solver(*mesh, byArea);
    std::vector<double> shares = {1.0};
    solver.run({100000, 0.05}, [&](const Progress& progress) {
        shares.push_back(progress.unshotShare);
        return true;
    });
    REQUIRE(shares.size() > 2);
    CHECK(shares.back() <= 0.05);
    CHECK(shares[shares.size() - 2] > 0.05);
    CHECK(solver.progress().shots == static_cast<int>(shares.size()) - 1);
    CHECK(solver.progress().unshotShare == Approx(solver.progress().unshot / solver.progress().emitted));
}

TEST_CASE("solver: where nothing emits there is no shot, and all is black") {
    const auto mesh = cube(Vec3f(0.5f), Vec3f(0.0f)).mesh(0.5f);
    Progressive solver(*mesh, byArea);
    for (MyPolygon& patch : mesh->patches) patch.color = Vec3f(9.0f);
    const Progress& progress = solver.run({});
    CHECK(progress.shots == 0);
    CHECK(progress.emitted == 0.0);
    CHECK(progress.unshotShare == 0.0);
    for (const MyPolygon& patch : mesh->patches) CHECK(patch.color == Vec3f(0.0f));
    CHECK_FALSE(solver.shoot());
}

TEST_CASE("solver: between black walls every lamp shoots once, and all is absorbed") {
    const auto mesh = lamp(Vec3f(0.0f)).mesh(0.25f);
    Progressive solver(*mesh, byArea);
    const Progress& progress = solver.run({1000, 0.0});
    CHECK(progress.shots == 16);
    CHECK(progress.unshot == 0.0);
    CHECK(progress.absorbed == Approx(3.0).epsilon(1e-5));
}

TEST_CASE("solver: it stops when the callback says so, and colours are made even then") {
    const auto mesh = lamp().mesh(0.25f);
    Progressive solver(*mesh, byArea);
    const Progress& progress = solver.run({1000, 0.0}, [](const Progress& so_far) { return so_far.shots < 3; });
    CHECK(progress.shots == 3);
    int bright = 0;
    for (const MyPolygon& patch : mesh->patches) {
        CHECK(patch.color.g == Approx(patch.rad.g / M_PI));
        bright += patch.color.g > 0.0f;
    }
    CHECK(bright == 96);
}

TEST_CASE("solver: without a shooter it stops") {
    const auto mesh = lamp().mesh(0.25f);
    Progressive solver(*mesh, [] { return static_cast<MyPolygon*>(nullptr); });
    CHECK(solver.run({}).shots == 0);
}

TEST_CASE("solver: radiosities that are no longer finite are an error that says after which shot") {
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    for (const float bad : {nan, infinity}) {
        const auto mesh = lamp().mesh(0.25f);
        int shots = 0;
        Progressive solver(*mesh, [&] {
            MyPolygon* shooter = byArea();
            if (++shots == 4) polygons[0]->formF = bad;
            return shooter;
        });
        CHECK_THROWS_WITH_AS(solver.run({}), doctest::Contains("no longer finite after shot 4"), Error);
    }
}

TEST_CASE("solver: what is absorbed, escaped and unshot adds up to what was emitted, whatever the form factors") {
    for (const float sum : {1.0f, 0.3f, 1.2f}) {
        CAPTURE(sum);
        const auto mesh = lamp(Vec3f(0.2f, 0.5f, 0.8f)).mesh(0.25f);
        Progressive solver(*mesh, [&] {
            MyPolygon* shooter = byArea();
            for (MyPolygon* patch : polygons) patch->formF *= sum;
            return shooter;
        });
        const Progress& progress = solver.run({200, 1e-3}, [](const Progress& now) {
            CHECK(now.total() == Approx(now.emitted).epsilon(1e-5));
            return true;
        });
        CHECK(progress.emitted == Approx(3.0));
        CHECK(progress.absorbed > 0.0);
        if (sum == 1.0f) CHECK(std::abs(progress.escaped) < 1e-5);
        if (sum < 1.0f) CHECK(progress.escaped > 0.5 * progress.emitted);
        if (sum > 1.0f) CHECK(progress.escaped < 0.0);
    }
}

TEST_CASE("solver: from one of two facing squares, what misses the other escapes") {
    Faces faces;
    faces.add(square(0, true), material(Vec3f(0.0f), Vec3f(2.0f)));
    faces.add(square(1, false), material(Vec3f(0.5f)));
    const auto mesh = faces.mesh(0.1f);
    Progressive solver(*mesh, calcAnalyticalFF);
    const Progress& progress = solver.run({100, 0.0});
    const double factor = 0.199824895698387;  // [Howell, C-11]
    CHECK(progress.emitted == Approx(6.0));
    CHECK(progress.escaped == Approx(6.0 * (1.0 - factor)).epsilon(1e-3));
    CHECK(progress.absorbed == Approx(6.0 * factor * 0.5).epsilon(2e-3));
    CHECK(progress.unshot == Approx(6.0 * factor * 0.5).epsilon(2e-3));
}

TEST_CASE("solver: it publishes its mesh and starts from the emission, however often") {
    const auto mesh = lamp().mesh(0.25f), other = lamp().mesh(0.5f);
    std::vector<std::vector<Vec3f>> found;
    for (int again = 0; again < 2; ++again) {
        other->publish();
        Progressive solver(*mesh, byArea);
        CHECK(polygons.size() == mesh->patches.size());
        CHECK(polygons[0] == mesh->patches.data());
        solver.run({50, 0.0});
        found.emplace_back();
        for (const MyPolygon& patch : mesh->patches) found.back().push_back(patch.rad);
    }
    CHECK(found[0] == found[1]);
}

TEST_CASE("solver: a stub that is not written yet comes through as it is") {
    const auto mesh = lamp().mesh(0.5f);
    Progressive solver(*mesh, []() -> MyPolygon* { throw NotImplemented("calcFF"); });
    CHECK_THROWS_WITH_AS(solver.run({}), "calcFF is not written yet", NotImplemented);
}
