#include <doctest/doctest.h>

#include "course/Extensions.h"

namespace {

// Remembers how the second pass was drawn; its picture has one colour.
struct Recorder : MirrorPass {
    bool showsMirror(int x, int y) const override { return x == 1 && y == 0; }
    radlab::Image draw(const glm::mat4& carry, const glm::vec4& plane, bool clockwiseFronts) const override {
        ++draws, world = carry, clip = plane, clockwise = clockwiseFronts;
        return radlab::Image(2, 2, Vec3f(0.5f));
    }
    mutable int draws = 0;
    mutable glm::mat4 world{0.0f};
    mutable glm::vec4 clip{0.0f};
    mutable bool clockwise = false;
};

float distanceBetween(const Vec3f& a, const Vec3f& b) { return length(a - b); }

}  // namespace

TEST_CASE("mirror: a point is carried as far behind the plane as it is in front, along the normal, and back again") {
    for (const Vec3f& normal : {Vec3f(0, 0, 1), Vec3f(0, -2, 0), Vec3f(1, 2, 3), Vec3f(-0.1f, 0.2f, -0.05f)}) {
        const Recorder pass;
        const Vec3f point(3, -1, 2), n = normalize(normal), across = normalize(cross(n, Vec3f(0.3f, 0.5f, 0.7f)));
        radlab::Image picture(2, 2);
        mirrorScene(pass, point, normal, Vec3f(1.0f), picture);
        CHECK(pass.draws == 1);
        CHECK(pass.clockwise);
        const auto carried = [&](const Vec3f& p) { return Vec3f(pass.world * glm::vec4(p, 1.0f)); };
        const Vec3f onMirror = point + 2.0f * across, inFront = onMirror + 1.5f * n;
        CHECK(distanceBetween(carried(point), point) < 1e-5f);
        CHECK(distanceBetween(carried(onMirror), onMirror) < 1e-5f);
        CHECK(distanceBetween(carried(inFront), onMirror - 1.5f * n) < 1e-5f);
        CHECK(distanceBetween(carried(carried(inFront)), inFront) < 1e-5f);
        CHECK(glm::determinant(pass.world) == doctest::Approx(-1.0));
        CHECK(glm::dot(pass.clip, glm::vec4(inFront, 1.0f)) > 0.0f);
        CHECK(glm::dot(pass.clip, glm::vec4(onMirror - n, 1.0f)) < 0.0f);
        CHECK(glm::dot(pass.clip, glm::vec4(onMirror, 1.0f)) == doctest::Approx(0.0).scale(1.0));
    }
}

TEST_CASE("mirror: its pixels alone get the reflected light on top of their own") {
    const Recorder pass;
    radlab::Image picture(2, 2, Vec3f(0.1f));
    mirrorScene(pass, Vec3f(0.0f), Vec3f(0, 0, 1), Vec3f(0.2f, 0.4f, 0.8f), picture);
    CHECK(distanceBetween(picture.at(1, 0), Vec3f(0.2f, 0.3f, 0.5f)) < 1e-6f);
    CHECK(picture.at(0, 0) == Vec3f(0.1f));
    CHECK(picture.at(0, 1) == Vec3f(0.1f));
    CHECK(picture.at(1, 1) == Vec3f(0.1f));
}
