// What holds for the drawing stages of any right solution; compiled with each one that is here.

#include "course/ProgRef.h"

#include <array>
#include <limits>

#include <doctest/doctest.h>

#include "TestPatches.h"
#include "gl/Context.h"

using namespace radlab;
using namespace radlab::test;
using doctest::Approx;

namespace {

bool finite(const Vec3f& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// The row of calcFF by hand, with the up vector of the solutions.
std::vector<double> rowByHand(Hemicube& hemicube, const MyPolygon& s) {
    hemicube.renderScene(s.center, vertices[s.vertex[0]]->position - s.center, s.normal, renderPatchIDs);
    hemicube.readIndexBuffer();
    std::vector<double> row(polygons.size());
    for (int y = 0; y < hemicube.rendersize; ++y)
        for (int x = 0; x < hemicube.rendersize; ++x)
            if (const int id = hemicube.getIndex(x, y)) row[id - 1] += hemicube.getDeltaFormFactor(x, y);
    return row;
}

}  // namespace

TEST_CASE("stage 5: every pixel shows the ID of the patch that its ray hits, with IDs of one, two and three bytes") {
    const auto context = GlContext::offscreen();
    const int size = 512;
    Hemicube hemicube(size);
    for (const int cells : {10, 20, 260}) {
        CAPTURE(cells);
        Faces faces;
        faces.add(square(0.5f, false));
        const auto mesh = faces.mesh(1.0f / static_cast<float>(cells));
        REQUIRE(mesh->patches.size() == static_cast<std::size_t>(cells * cells));
        mesh->publish();
        // The top face sees just the square: pixel (x, y) looks along right x, up y, and right is direction x up.
        hemicube.renderScene(Vec3f(0.5f, 0.5f, 0), Vec3f(0, 1, 0), Vec3f(0, 0, 1), renderPatchIDs);
        hemicube.readIndexBuffer();
        int wrong = 0, most = 0;
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const Vec3f hit(1.0 - (x + 0.5) / size, (y + 0.5) / size, 0.5);
                const int id = hemicube.getIndex(size / 2 + x, size / 2 + y);
                most = std::max(most, id);
                if (id < 1 || id > cells * cells) {
                    ++wrong;
                    continue;
                }
                const Vec3f aside = glm::abs(polygons[id - 1]->center - hit);
                wrong += std::max(aside.x, aside.y) > 0.5 / cells + 1e-4;
            }
        CHECK(wrong == 0);
        CHECK(most == cells * cells);
    }
}

TEST_CASE("stage 5: triangles are drawn as triangles") {
    const auto context = GlContext::offscreen();
    Hemicube hemicube(64);
    Faces faces;
    faces.add({{0, 0, 0.5f}, {0, 1, 0.5f}, {1, 0, 0.5f}});
    const auto mesh = faces.mesh(10.0f);
    mesh->publish();
    hemicube.renderScene(Vec3f(0.5f, 0.5f, 0), Vec3f(0, 1, 0), Vec3f(0, 0, 1), renderPatchIDs);
    hemicube.readIndexBuffer();
    int covered = 0;
    for (int y = 32; y < 96; ++y)
        for (int x = 32; x < 96; ++x) covered += hemicube.getIndex(x, y) == 1;
    CHECK(covered == Approx(64 * 64 / 2.0).epsilon(0.02));
}

TEST_CASE("stage 5: only drawing is done: matrices and viewport stay, and no glBegin is left open") {
    const auto context = GlContext::offscreen();
    Hemicube hemicube(16);
    const auto mesh = roomWithTriangle();
    const auto state = [] {
        std::array<double, 36> values{};
        glGetDoublev(GL_MODELVIEW_MATRIX, &values[0]);
        glGetDoublev(GL_PROJECTION_MATRIX, &values[16]);
        glGetDoublev(GL_VIEWPORT, &values[32]);
        return values;
    };
    int draws = 0;
    hemicube.renderScene(polygons[0]->center, Vec3f(1, 0, 0), polygons[0]->normal, [&] {
        const auto before = state();
        renderPatchIDs();
        CHECK(glGetError() == GL_NO_ERROR);  // inside glBegin it is itself an error
        CHECK(state() == before);
        ++draws;
    });
    CHECK(draws == 5);
}

TEST_CASE("stage 6: the row equals one made by hand, and the brightest patch is returned") {
    const auto context = GlContext::offscreen();
    Hemicube hemicube(64);
    const auto mesh = roomWithTriangle();
    for (std::size_t s = 0; s < polygons.size(); s += 5) {
        CAPTURE(s);
        const MyPolygon* shooter = onlyShooter(s);
        REQUIRE(calcFF(&hemicube) == shooter);
        std::vector<float> found;
        for (const MyPolygon* patch : polygons) found.push_back(patch->formF);
        const std::vector<double> row = rowByHand(hemicube, *shooter);
        for (std::size_t i = 0; i < row.size(); ++i) CHECK(found[i] == Approx(row[i]).epsilon(1e-5));
    }
}

TEST_CASE("stage 6: form factors of an earlier shot are forgotten") {
    const auto context = GlContext::offscreen();
    Hemicube hemicube(64);
    const auto mesh = roomWithTriangle();
    onlyShooter(0);
    for (MyPolygon* patch : polygons) patch->formF = 5.0f;
    calcFF(&hemicube);
    double sum = 0.0;
    for (const MyPolygon* patch : polygons) {
        CHECK(patch->formF >= 0.0f);
        sum += patch->formF;
    }
    CHECK(sum == Approx(1.0).epsilon(1e-5));
    CHECK(polygons[0]->formF == 0.0f);
    CHECK(polygons[1]->formF == 0.0f);  // in the shooter's plane
}

TEST_CASE("stage 6: what stands in between takes the light") {
    const auto context = GlContext::offscreen();
    Hemicube hemicube(128);
    Faces faces;
    faces.add({{-0.01f, -0.01f, 0}, {0.01f, -0.01f, 0}, {0.01f, 0.01f, 0}, {-0.01f, 0.01f, 0}});
    faces.add({{-1, -1, 1}, {-1, 1, 1}, {1, 1, 1}, {1, -1, 1}});
    const auto open = faces.mesh(10.0f);
    open->publish();
    onlyShooter(0);
    calcFF(&hemicube);
    CHECK(polygons[1]->formF == Approx(4 * 0.138531605994893).epsilon(0.01));  // [Howell, B-3], four quarters
    faces.add({{-0.5f, -0.5f, 0.5f}, {-0.5f, 0.5f, 0.5f}, {0.5f, 0.5f, 0.5f}, {0.5f, -0.5f, 0.5f}});
    const auto blocked = faces.mesh(10.0f);
    blocked->publish();
    onlyShooter(0);
    calcFF(&hemicube);
    CHECK(polygons[1]->formF < 0.02f);
    CHECK(polygons[2]->formF == Approx(4 * 0.138531605994893).epsilon(0.02));
}

TEST_CASE("stage 6: without patches there is no shooter") {
    const auto context = GlContext::offscreen();
    Hemicube hemicube(16);
    polygons.clear();
    CHECK(calcFF(&hemicube) == nullptr);
}

TEST_CASE("a few shots with every function leave numbers only") {
    const auto context = GlContext::offscreen();
    Hemicube hemicube(32);
    const auto mesh = roomWithTriangle();
    onlyShooter(3, Vec3f(100.0f, 10.0f, 1.0f));
    for (int shot = 0; shot < 20; ++shot) distributeEnergy(shot % 2 ? calcAnalyticalFF() : calcFF(&hemicube));
    colorReconstruction();
    for (const MyPolygon* patch : polygons) {
        CHECK(finite(patch->color));
        CHECK(patch->color.r >= 0.0f);
    }
    for (const MyVertex* vertex : vertices) CHECK(finite(vertex->color));
}
