#pragma once

#include <string>
#include <vector>

#include "course/Face.h"

namespace radlab {

/// From where a scene is looked at.
struct Camera {
    std::string name;
    Vec3f position{0.0f, 0.0f, 10.0f};
    Vec3f direction{0.0f, 0.0f, -1.0f};  ///< unit vector
    Vec3f up{0.0f, 1.0f, 0.0f};          ///< unit vector at a right angle to direction
    float fieldOfView = 0.785398f;       ///< radians across the smaller side of the picture, 0 to π
};

/// A scene in world coordinates: polygons with materials, and the views of it.
struct Scene {
    std::string file;             ///< the file that it was read from, for messages
    std::vector<Vec3f> vertices;  ///< positions, in the scene's own unit of length
    std::vector<Face> faces;
    std::vector<Camera> cameras;  ///< the file's viewpoints, in their order; may be empty
    Vec3f background{0.0f};       ///< linear RGB
};

/// Where a face was read, for messages: file:line.
inline std::string placeOf(const Face& face) { return face.where.file + ":" + std::to_string(face.where.line); }

}  // namespace radlab
