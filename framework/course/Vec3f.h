#pragma once

#include <cmath>

#include <glm/glm.hpp>

/// A vector of three floats: a position, a direction or an RGB colour.
///
/// It is GLM's vec3, so dot, cross, length and normalize are found without a qualifier.
using Vec3f = glm::vec3;

// GLM's operators take a float only; M_1_PI and 0.5 are doubles.
namespace glm {
inline vec3 operator*(const vec3& v, double s) { return v * static_cast<float>(s); }
inline vec3 operator*(double s, const vec3& v) { return v * static_cast<float>(s); }
inline vec3 operator/(const vec3& v, double s) { return v / static_cast<float>(s); }
}  // namespace glm

/// The squared length of v.
inline float sqr_length(const Vec3f& v) { return glm::dot(v, v); }
