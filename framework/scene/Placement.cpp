#include "scene/Placement.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace radlab {

namespace {

glm::dmat4 translation(const glm::dvec3& by) {
    glm::dmat4 result(1.0);
    result[3] = glm::dvec4(by, 1.0);
    return result;
}

glm::dmat3 diagonal(const glm::dvec3& scale) { return {scale.x, 0, 0, 0, scale.y, 0, 0, 0, scale.z}; }

glm::dvec3 readScale(const X3dNode& node) {
    const glm::dvec3 scale = node.vector("scale", glm::dvec3(1.0));
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(scale[axis]) < std::numeric_limits<float>::min())
            node.fail("scale flattens what is below it, found a 0, expected three numbers other than 0");
    return scale;
}

// Casting a double out of a float's range is undefined, so that an overflow has to be seen before.
float toFloat(double value) {
    if (!(std::abs(value) <= std::numeric_limits<float>::max())) return std::numeric_limits<float>::infinity();
    return static_cast<float>(value);
}

}  // namespace

glm::dmat3 rotationAbout(const glm::dvec3& axis, double angle) {
    // The largest component becomes 1 first, so that no square overflows or vanishes.
    const double largest = std::max({std::abs(axis.x), std::abs(axis.y), std::abs(axis.z)});
    const glm::dvec3 a = glm::normalize(axis / largest);
    const double c = std::cos(angle);
    const glm::dvec3 s = a * std::sin(angle);
    const glm::dvec3 t = a * (1.0 - c);
    return {t.x * a.x + c,   t.x * a.y + s.z, t.x * a.z - s.y,  //
            t.y * a.x - s.z, t.y * a.y + c,   t.y * a.z + s.x,  //
            t.z * a.x + s.y, t.z * a.y - s.x, t.z * a.z + c};
}

glm::dmat3 readRotation(const X3dNode& node, const char* field) {
    const auto values = node.numbers(field, 4);
    if (values.empty() || values[3] == 0) return glm::dmat3(1.0);
    const glm::dvec3 axis(values[0], values[1], values[2]);
    if (axis == glm::dvec3(0.0))
        node.fail(std::string(field) + " turns about no axis, found the axis 0 0 0, expected any other");
    return rotationAbout(axis, values[3]);
}

Placement readTransform(const X3dNode& node) {
    const glm::dvec3 center = node.vector("center", glm::dvec3(0.0));
    const glm::dvec3 scale = readScale(node);
    const glm::dmat3 rotation = readRotation(node, "rotation");
    const glm::dmat3 scaleOrientation = readRotation(node, "scaleOrientation");
    const glm::dmat3 linear = rotation * scaleOrientation * diagonal(scale) * glm::transpose(scaleOrientation);
    const glm::dvec3 moved = node.vector("translation", glm::dvec3(0.0));
    const bool mirrored = (scale.x < 0) != ((scale.y < 0) != (scale.z < 0));
    return {translation(moved) * translation(center) * glm::dmat4(linear) * translation(-center), mirrored};
}

Vec3f placed(const Placement& placement, const glm::dvec3& point) {
    const glm::dvec4 moved = placement.matrix * glm::dvec4(point, 1.0);
    return {toFloat(moved.x), toFloat(moved.y), toFloat(moved.z)};
}

bool isFinite(const Vec3f& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace radlab
