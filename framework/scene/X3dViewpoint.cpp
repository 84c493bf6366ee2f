#include "scene/X3dViewpoint.h"

#include <cmath>

#include "scene/Number.h"

namespace radlab {

namespace {

constexpr double pi = 3.14159265358979323846;

float readFieldOfView(const X3dNode& node) {
    const double angle = node.number("fieldOfView", pi / 4);
    // The float may be rounded up to where the double was not.
    const double rounded = static_cast<float>(angle);
    if (!(rounded > 0 && rounded < pi))
        node.fail("fieldOfView is out of range, found " + numberText(angle) +
                  ", expected an angle in radians between 0 and 3.14159");
    return static_cast<float>(angle);
}

glm::dvec3 unit(const glm::dvec3& v) { return v / glm::length(v); }

}  // namespace

Camera readViewpoint(const X3dNode& node, const Placement& placement) {
    const glm::dmat3 turned = glm::dmat3(placement.matrix) * readRotation(node, "orientation");
    const glm::dvec3 direction = unit(turned * glm::dvec3(0, 0, -1));
    const glm::dvec3 up = unit(turned * glm::dvec3(0, 1, 0));

    Camera camera;
    camera.name = node.text(node.has("description") ? "description" : "DEF");
    camera.position = placed(placement, node.vector("position", glm::dvec3(0, 0, 10)));
    camera.direction = Vec3f(direction);
    camera.up = Vec3f(unit(up - glm::dot(up, direction) * direction));
    camera.fieldOfView = readFieldOfView(node);
    if (!isFinite(camera.position) || !isFinite(camera.direction) || !isFinite(camera.up))
        node.fail("the Transforms above place it nowhere: a coordinate is too large, or a scale flattens it");
    return camera;
}

}  // namespace radlab
