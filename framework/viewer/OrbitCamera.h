#pragma once

#include <vector>

#include "scene/Scene.h"

namespace radlab {

/// A camera that turns round a point of the scene. Plain data, so that it can lie in memory that processes share.
struct OrbitCamera {
    glm::vec3 position{0.0f, 0.0f, 10.0f};
    glm::vec3 direction{0.0f, 0.0f, -1.0f};  ///< unit vector
    glm::vec3 up{0.0f, 1.0f, 0.0f};          ///< unit vector at a right angle to direction
    glm::vec3 pole{0.0f, 1.0f, 0.0f};        ///< the axis that orbit turns round
    float distance = 10.0f;                  ///< to the point that it turns round
    float fieldOfView = 0.785398f;           ///< radians across the smaller side

    /// The point that it turns round.
    glm::vec3 target() const { return position + distance * direction; }

    /// The camera as pictures take it.
    Camera camera() const;

    /// Turns round the target: by `yaw` radians round the pole, by `pitch` up or down, never over the pole.
    void orbit(float yaw, float pitch);

    /// Moves along its own plane, by shares of the picture's smaller side at the target's distance.
    void pan(float right, float upward);

    /// Moves towards the target: the distance is multiplied by `factor`, > 0.
    void zoom(float factor);

    /// Moves back, without turning, until a ball of that centre and radius just fills the smaller side.
    void frame(const glm::vec3& centre, float radius);
};

/// An orbit camera that looks as the camera does, and turns round what lies halfway through the scene.
OrbitCamera orbitFrom(const Camera& camera, const std::vector<Vec3f>& positions);

/// A ball round points: the middle of their box, and the distance to the farthest.
struct Ball {
    glm::vec3 centre{0.0f};
    float radius = 1.0f;
};
Ball ballRound(const std::vector<Vec3f>& positions);

}  // namespace radlab
