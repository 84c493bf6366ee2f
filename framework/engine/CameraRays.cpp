#include "engine/CameraRays.h"

#include <cmath>

#include "base/Error.h"

namespace radlab::engine {

CameraRays::CameraRays(const Frame& frame) : position(frame.camera.position) {
    RADLAB_CHECK(frame.width > 0);
    RADLAB_CHECK(frame.height > 0);
    const Point ahead = glm::normalize(Point(frame.camera.direction));
    const Point across = glm::normalize(glm::cross(ahead, Point(frame.camera.up)));
    const double half = std::tan(0.5 * static_cast<double>(frame.camera.fieldOfView));
    const double pixel = 2.0 * half / std::min(frame.width, frame.height);
    right = pixel * across;
    down = pixel * glm::cross(ahead, across);
    topLeft = ahead - 0.5 * frame.width * right - 0.5 * frame.height * down;
}

}  // namespace radlab::engine
