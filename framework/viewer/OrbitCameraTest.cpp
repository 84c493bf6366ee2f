#include "viewer/OrbitCamera.h"

#include <cmath>

#include <doctest/doctest.h>

using namespace radlab;
using doctest::Approx;

namespace {

bool near(const glm::vec3& a, const glm::vec3& b) { return glm::distance(a, b) < 1e-4f; }

const float quarter = static_cast<float>(M_PI / 2);

}  // namespace

TEST_CASE("a quarter turn round the pole looks along the other axis, from as far, at the same point") {
    OrbitCamera camera;
    const glm::vec3 target = camera.target();
    camera.orbit(quarter, 0.0f);
    CHECK(near(camera.target(), target));
    CHECK(near(camera.direction, {-1, 0, 0}));
    CHECK(near(camera.position, {10, 0, 0}));
    CHECK(near(camera.up, {0, 1, 0}));
}

TEST_CASE("a whole turn in many steps changes nothing, and the frame stays at right angles") {
    OrbitCamera camera;
    camera.orbit(0.3f, 0.4f);
    const OrbitCamera before = camera;
    for (int i = 0; i < 64; ++i) camera.orbit(4.0f * quarter / 64.0f, 0.0f);
    CHECK(near(camera.position, before.position));
    CHECK(std::abs(glm::dot(camera.direction, camera.up)) < 1e-5f);
    CHECK(glm::length(camera.up) == Approx(1.0));
}

TEST_CASE("pitch never goes over the pole, however far it is dragged") {
    for (const float pitch : {100.0f, -100.0f}) {
        OrbitCamera camera;
        camera.orbit(0.0f, pitch);
        camera.orbit(0.0f, pitch);
        CHECK(std::abs(glm::dot(camera.direction, camera.pole)) < 1.0f);
        CHECK(std::abs(glm::dot(camera.direction, camera.pole)) > 0.99f);
        CHECK(glm::dot(camera.up, camera.pole) > 0.0f);
        CHECK(camera.distance == 10.0f);
    }
}

TEST_CASE("a pan of 1 moves by the picture's side at the target, a zoom of 1/2 halves the distance to it") {
    OrbitCamera camera;
    camera.fieldOfView = quarter;
    camera.pan(1.0f, 0.5f);
    CHECK(near(camera.position, {20, 10, 10}));
    const glm::vec3 target = camera.target();
    camera.zoom(0.5f);
    CHECK(camera.distance == Approx(5.0));
    CHECK(near(camera.target(), target));
}

TEST_CASE("a framed ball touches the edges of the view") {
    OrbitCamera camera;
    camera.fieldOfView = quarter;
    camera.frame({1, 2, 3}, 2.0f);
    CHECK(glm::distance(camera.position, glm::vec3(1, 2, 3)) == Approx(2.0 / std::sin(M_PI / 4)));
    CHECK(near(camera.target(), {1, 2, 3}));
    CHECK(near(camera.direction, {0, 0, -1}));
}

TEST_CASE("the ball round a box is round its middle; an orbit from a camera looks as that camera does") {
    const std::vector<Vec3f> corners = {{0, 0, 0}, {2, 0, 0}, {2, 4, 4}, {0, 4, 4}};
    const Ball ball = ballRound(corners);
    CHECK(near(ball.centre, {1, 2, 2}));
    CHECK(ball.radius == Approx(3.0));
    Camera camera;
    camera.position = Vec3f(1, 2, 10);
    const OrbitCamera orbit = orbitFrom(camera, corners);
    CHECK(near(orbit.target(), {1, 2, 2}));
    CHECK(near(orbit.camera().position, camera.position));
    CHECK(near(orbit.camera().up, camera.up));
}
