#include "viewer/OrbitCamera.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace radlab {

namespace {

constexpr float nearestToPole = 0.02f;  // radians

glm::vec3 turned(const glm::vec3& v, float angle, const glm::vec3& axis) {
    return glm::vec3(glm::rotate(glm::dmat4(1.0), static_cast<double>(angle), glm::dvec3(axis)) * glm::dvec4(v, 0.0));
}

}  // namespace

Camera OrbitCamera::camera() const { return {"", position, direction, up, fieldOfView}; }

void OrbitCamera::orbit(float yaw, float pitch) {
    const glm::vec3 centre = target();
    const glm::vec3 right = glm::normalize(glm::cross(direction, up));
    // The angle between direction and pole stays between a little and half a turn less a little.
    const float angle = std::acos(std::clamp(glm::dot(direction, pole), -1.0f, 1.0f));
    const float wanted = std::clamp(angle - pitch, nearestToPole, static_cast<float>(M_PI) - nearestToPole);
    direction = turned(turned(direction, angle - wanted, right), yaw, pole);
    const glm::vec3 newRight = turned(right, yaw, pole);
    direction = glm::normalize(direction);
    up = glm::normalize(glm::cross(newRight, direction));
    position = centre - distance * direction;
}

void OrbitCamera::pan(float right, float upward) {
    const float side = 2.0f * distance * std::tan(0.5f * fieldOfView);
    position += side * (right * glm::normalize(glm::cross(direction, up)) + upward * up);
}

void OrbitCamera::zoom(float factor) {
    const glm::vec3 centre = target();
    distance *= factor;
    position = centre - distance * direction;
}

void OrbitCamera::frame(const glm::vec3& centre, float radius) {
    distance = radius / std::sin(0.5f * fieldOfView);
    position = centre - distance * direction;
}

Ball ballRound(const std::vector<Vec3f>& positions) {
    if (positions.empty()) return {};
    glm::vec3 low = positions.front(), high = low;
    for (const Vec3f& p : positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    Ball ball{0.5f * (low + high), 0.0f};
    for (const Vec3f& p : positions) ball.radius = std::max(ball.radius, glm::distance(p, ball.centre));
    if (!(ball.radius > 0.0f)) ball.radius = 1.0f;
    return ball;
}

OrbitCamera orbitFrom(const Camera& camera, const std::vector<Vec3f>& positions) {
    const Ball ball = ballRound(positions);
    OrbitCamera orbit;
    orbit.position = camera.position;
    orbit.direction = glm::normalize(camera.direction);
    orbit.up = glm::normalize(camera.up - glm::dot(camera.up, orbit.direction) * orbit.direction);
    orbit.pole = orbit.up;
    orbit.fieldOfView = camera.fieldOfView;
    const float depth = glm::dot(ball.centre - camera.position, orbit.direction);
    orbit.distance = std::max(depth, 0.1f * ball.radius);
    return orbit;
}

}  // namespace radlab
