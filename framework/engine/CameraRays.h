#pragma once

#include "engine/Polygon.h"
#include "scene/Scene.h"

namespace radlab::engine {

/// The frame of a picture: from where, and how large.
struct Frame {
    Camera camera;
    int width = 800, height = 800;
    Point background{0.0};  ///< radiance where the camera sees past everything
};

/// The rays of a camera through the points of its picture.
class CameraRays {
public:
    explicit CameraRays(const Frame& frame);

    const Point& eye() const { return position; }

    /// The unit direction through a point of the picture: in pixels from its top left corner.
    Point direction(double x, double y) const { return glm::normalize(topLeft + x * right + y * down); }

private:
    Point position, topLeft, right, down;  // the last three on the plane at distance 1
};

}  // namespace radlab::engine
