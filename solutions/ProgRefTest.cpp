// What holds for any right solution; compiled with each one that is here.

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

// F from s to j by the formula, in double, over A/(πr²): the product of the cosines.
double cosines(const MyPolygon& s, const MyPolygon& j) {
    const glm::dvec3 between = glm::normalize(glm::dvec3(j.center) - glm::dvec3(s.center));
    return std::max(glm::dot(glm::dvec3(s.normal), between), 0.0) *
           std::max(-glm::dot(glm::dvec3(j.normal), between), 0.0);
}

double nearness(const MyPolygon& s, const MyPolygon& j) {
    const glm::dvec3 between = glm::dvec3(j.center) - glm::dvec3(s.center);
    return double(j.area) / (M_PI * glm::dot(between, between));
}

// Two patches of area 1 at the distance 2, front to front, the first one the shooter.
std::unique_ptr<PatchMesh> pair() {
    auto mesh = std::make_unique<PatchMesh>();
    mesh->patches.resize(2);
    for (MyPolygon& patch : mesh->patches) patch.area = 1.0f;
    mesh->patches[0].normal = Vec3f(0, 0, 1);
    mesh->patches[1].normal = Vec3f(0, 0, -1);
    mesh->patches[1].center = Vec3f(0, 0, 2);
    mesh->publish();
    onlyShooter(0);
    return mesh;
}

// Where the light of a patch goes, channel by channel: the sum over `polygons` of a member times area.
glm::dvec3 power(Vec3f MyPolygon::*radiosity) {
    glm::dvec3 sum(0.0);
    for (const MyPolygon* patch : polygons) sum += glm::dvec3(patch->*radiosity) * double(patch->area);
    return sum;
}

}  // namespace

TEST_CASE("stage 1: without patches there is no brightest one") {
    const PatchMesh none;
    polygons.clear();
    CHECK(maxenergy_patch() == nullptr);
}

TEST_CASE("stage 1: every patch can be the brightest, first and last included") {
    const auto mesh = scattered(20, 1);
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        const MyPolygon* brightest = onlyShooter(i);
        CHECK(maxenergy_patch() == brightest);
    }
}

TEST_CASE("stage 1: all channels count, by the length of unshot_rad, whatever was shot before") {
    const auto mesh = pair();
    MyPolygon &first = mesh->patches[0], &second = mesh->patches[1];
    first.unshot_rad = Vec3f(3, 0, 0);
    second.unshot_rad = Vec3f(2, 2, 0);  // a larger sum, but a smaller length
    second.rad = second.color = Vec3f(100);
    CHECK(maxenergy_patch() == &first);
    second.unshot_rad = Vec3f(2, 2, 2);  // a smaller largest channel, but a larger length
    CHECK(maxenergy_patch() == &second);
    first.unshot_rad = Vec3f(0, 0, 3.5f);
    CHECK(maxenergy_patch() == &first);
}

TEST_CASE("stage 1: of equal patches the same one is found every time, even where nothing is unshot") {
    const auto mesh = scattered(50, 2);
    for (const float unshot : {1.0f, 0.0f}) {
        for (MyPolygon* patch : polygons) {
            patch->area = 1.0f;
            patch->unshot_rad = Vec3f(unshot);
        }
        const MyPolygon* found = maxenergy_patch();
        REQUIRE(found != nullptr);
        for (int again = 0; again < 10; ++again) {
            polygons[again]->formF = polygons[again]->rad.x = static_cast<float>(again);
            CHECK(maxenergy_patch() == found);
        }
    }
}

TEST_CASE("stage 2: form factors equal the point to point formula in double to 1e-5") {
    int facing = 0;
    for (const unsigned seed : {1u, 2u, 3u}) {
        const auto mesh = scattered(100, seed);
        for (std::size_t s = 0; s < polygons.size(); s += 9) {
            const MyPolygon& shooter = *onlyShooter(s);
            REQUIRE(calcAnalyticalFF() == &shooter);
            for (const MyPolygon* patch : polygons) {
                if (patch == &shooter) continue;
                const double product = cosines(shooter, *patch), most = nearness(shooter, *patch);
                // Near the horizon a float's cosine is right to about 1e-7 itself, not of its value.
                CHECK(std::abs(patch->formF - product * most) <= 1e-5 * product * most + 3e-7 * most);
                facing += product > 0.1;
            }
        }
    }
    CHECK(facing > 300);
}

TEST_CASE("stage 2: the shooter has no form factor to itself, whatever it had before") {
    const auto mesh = scattered(10, 4);
    for (std::size_t s = 0; s < polygons.size(); ++s) {
        const MyPolygon* shooter = onlyShooter(s);
        calcAnalyticalFF();
        CHECK(shooter->formF == 0.0f);
    }
}

TEST_CASE("stage 2: where either patch faces away nothing arrives") {
    const auto mesh = pair();
    MyPolygon &shooter = mesh->patches[0], &patch = mesh->patches[1];
    for (const int shooterSide : {1, -1})
        for (const int patchSide : {1, -1}) {
            CAPTURE(shooterSide);
            CAPTURE(patchSide);
            shooter.normal = Vec3f(0.6f, 0, 0.8f * static_cast<float>(shooterSide));
            patch.normal = Vec3f(0, 0.6f, -0.8f * static_cast<float>(patchSide));
            patch.formF = 7.0f;
            calcAnalyticalFF();
            if (shooterSide == 1 && patchSide == 1)
                CHECK(patch.formF == Approx(0.64 / (4 * M_PI)));
            else
                CHECK(patch.formF == 0.0f);
        }
}

TEST_CASE("stage 2: form factors have no unit: the same at every scale, and reciprocal") {
    for (const float scale : {1e-3f, 1.0f, 1e3f}) {
        CAPTURE(scale);
        const auto mesh = pair();
        mesh->patches[1].center *= scale;
        mesh->patches[0].area = 3.0f * scale * scale;
        mesh->patches[1].area = scale * scale;
        calcAnalyticalFF();
        CHECK(mesh->patches[1].formF == Approx(1.0 / (4 * M_PI)));
        onlyShooter(1);
        CHECK(calcAnalyticalFF() == &mesh->patches[1]);
        CHECK(mesh->patches[0].formF == Approx(3.0 / (4 * M_PI)));
    }
}

TEST_CASE("stage 2: patches whose centres coincide have finite form factors") {
    const auto mesh = pair();
    mesh->patches[1].center = mesh->patches[0].center;
    mesh->patches[1].formF = std::numeric_limits<float>::quiet_NaN();
    calcAnalyticalFF();
    CHECK(std::isfinite(mesh->patches[1].formF));
}

TEST_CASE("stage 2: without patches there is no shooter") {
    polygons.clear();
    CHECK(calcAnalyticalFF() == nullptr);
}

TEST_CASE("stage 3: every other patch gains reflectance x unshot x form factor x ratio of areas, per channel") {
    for (const unsigned seed : {1u, 2u, 3u}) {
        const auto mesh = scattered(40, seed);
        const std::vector<MyPolygon> before = mesh->patches;
        const MyPolygon& shooter = before[7];
        CHECK(distributeEnergy(&mesh->patches[7]));
        for (std::size_t j = 0; j < before.size(); ++j) {
            if (j == 7) continue;
            const MyPolygon &was = before[j], &is = mesh->patches[j];
            for (int c = 0; c < 3; ++c) {
                const double gain = double(was.diffuse[c]) * double(shooter.unshot_rad[c]) * double(was.formF) *
                                    double(shooter.area) / double(was.area);
                CHECK(is.rad[c] == Approx(was.rad[c] + gain).epsilon(1e-6));
                CHECK(is.unshot_rad[c] == Approx(was.unshot_rad[c] + gain).epsilon(1e-6));
            }
            CHECK(is.formF == was.formF);
            CHECK(is.diffuse == was.diffuse);
        }
    }
}

TEST_CASE("stage 3: the shooter has shot all, and keeps what it radiates") {
    const auto mesh = scattered(10, 5);  // with a form factor to itself left from before
    MyPolygon& shooter = mesh->patches[3];
    const Vec3f rad = shooter.rad;
    distributeEnergy(&shooter);
    CHECK(shooter.unshot_rad == Vec3f(0.0f));
    CHECK(shooter.rad == rad);
}

TEST_CASE("stage 3: channels do not mix") {
    const auto mesh = pair();
    MyPolygon& patch = mesh->patches[1];
    patch.formF = 0.5f;
    patch.diffuse = Vec3f(1.0f, 0.5f, 0.0f);
    patch.unshot_rad = Vec3f(0.0f);
    mesh->patches[0].unshot_rad = Vec3f(0.0f, 8.0f, 4.0f);
    distributeEnergy(&mesh->patches[0]);
    CHECK(patch.rad == Vec3f(0, 2, 0));
    CHECK(patch.unshot_rad == Vec3f(0, 2, 0));
}

TEST_CASE("stage 3: with form factors that sum to 1, white patches pass on all power and grey ones their share") {
    for (const float reflectance : {1.0f, 0.25f, 0.0f}) {
        CAPTURE(reflectance);
        const auto mesh = scattered(200, 6);
        MyPolygon& shooter = mesh->patches[50];
        shooter.formF = 0.0f;
        float sum = 0.0f;
        for (const MyPolygon* patch : polygons) sum += patch->formF;
        for (MyPolygon* patch : polygons) {
            patch->formF /= sum;
            patch->diffuse = Vec3f(reflectance);
        }
        const glm::dvec3 shot = glm::dvec3(shooter.unshot_rad) * double(shooter.area);
        const glm::dvec3 before = power(&MyPolygon::unshot_rad), radBefore = power(&MyPolygon::rad);
        distributeEnergy(&shooter);
        const glm::dvec3 after = power(&MyPolygon::unshot_rad), radAfter = power(&MyPolygon::rad);
        for (int c = 0; c < 3; ++c) {
            CHECK(after[c] == Approx(before[c] - (1.0 - reflectance) * shot[c]).epsilon(1e-6));
            CHECK(radAfter[c] == Approx(radBefore[c] + reflectance * shot[c]).epsilon(1e-6));
        }
    }
}

TEST_CASE("stage 3: without a shooter nothing is shot") {
    const auto mesh = scattered(5, 7);
    const std::vector<MyPolygon> before = mesh->patches;
    CHECK_FALSE(distributeEnergy(nullptr));
    for (std::size_t i = 0; i < before.size(); ++i) {
        CHECK(mesh->patches[i].rad == before[i].rad);
        CHECK(mesh->patches[i].unshot_rad == before[i].unshot_rad);
    }
}

TEST_CASE("stage 4: a patch's colour is its radiance, radiosity over pi") {
    const auto mesh = scattered(30, 8);
    for (MyPolygon* patch : polygons) patch->vertices = 0;
    colorReconstruction();
    for (const MyPolygon* patch : polygons)
        for (int c = 0; c < 3; ++c) CHECK(patch->color[c] == Approx(patch->rad[c] / M_PI).epsilon(1e-6));
}

TEST_CASE("stage 4: a vertex has the mean colour and radiosity of the patches round it") {
    Faces faces;
    faces.add(square(0, true));
    const auto mesh = faces.mesh(0.5f);
    mesh->publish();
    for (std::size_t i = 0; i < 4; ++i) mesh->patches[i].rad = Vec3f(1 << i, 10 << i, 0.0f);
    colorReconstruction();
    std::array<int, 5> withCount{};
    for (std::size_t k = 0; k < mesh->corners.size(); ++k) {
        glm::dvec3 sum(0.0);
        int count = 0;
        for (const MyPolygon& patch : mesh->patches)
            for (const int corner : patch.vertex)
                if (corner == static_cast<int>(k)) {
                    sum += glm::dvec3(patch.rad);
                    ++count;
                }
        const MyVertex& vertex = mesh->corners[k];
        REQUIRE(count > 0);
        REQUIRE(vertex.colorcount == count);
        ++withCount[count];
        for (int c = 0; c < 3; ++c) {
            CHECK(vertex.rad[c] == Approx(sum[c] / count).epsilon(1e-6));
            CHECK(vertex.color[c] == Approx(sum[c] / count / M_PI).epsilon(1e-6));
        }
    }
    CHECK(withCount == std::array<int, 5>{0, 4, 4, 0, 1});  // corners, edges, middle
}

TEST_CASE("stage 4: called again it gives the same, and triangles have three corners only") {
    const auto mesh = roomWithTriangle();
    for (std::size_t i = 0; i < polygons.size(); ++i) polygons[i]->rad = Vec3f(i, 1.0f, 0.5f * static_cast<float>(i));
    colorReconstruction();
    const std::vector<MyVertex> once = mesh->corners;
    const std::vector<MyPolygon> patchesOnce = mesh->patches;
    colorReconstruction();
    for (std::size_t k = 0; k < once.size(); ++k) {
        CHECK(mesh->corners[k].color == once[k].color);
        CHECK(mesh->corners[k].rad == once[k].rad);
        CHECK(mesh->corners[k].colorcount == once[k].colorcount);
        CHECK(once[k].color.g == Approx(1.0 / M_PI));  // a mean of equals
    }
    for (std::size_t i = 0; i < patchesOnce.size(); ++i) CHECK(mesh->patches[i].color == patchesOnce[i].color);
}

TEST_CASE("stage 4: a vertex that no patch uses is black and finite, whatever it was before") {
    Faces faces;
    faces.add(square(0, true));
    const auto mesh = faces.mesh(1.0f);
    MyVertex orphan;
    orphan.colorcount = 3;
    orphan.color = orphan.rad = Vec3f(std::numeric_limits<float>::quiet_NaN());
    mesh->corners.push_back(orphan);
    mesh->publish();
    mesh->patches[0].rad = Vec3f(2.0f);
    colorReconstruction();
    CHECK(mesh->corners.back().colorcount == 0);
    CHECK(mesh->corners.back().color == Vec3f(0.0f));
    CHECK(mesh->corners.back().rad == Vec3f(0.0f));
    CHECK(mesh->corners.front().rad == Vec3f(2.0f));
}

TEST_CASE("stage 4: without patches nothing happens") {
    polygons.clear();
    vertices.clear();
    CHECK_NOTHROW(colorReconstruction());
}
