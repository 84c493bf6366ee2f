#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/Error.h"
#include "course/Vec3f.h"

namespace radlab {

/// What a surface is made of. All colours are linear RGB.
struct Material {
    Vec3f diffuse{0.8f};        ///< reflectance ρ, 0 to 1 per channel
    Vec3f emissive{0.0f};       ///< emitted radiosity E, W/m² per channel, any value >= 0
    Vec3f specular{0.0f};       ///< mirror reflectance, 0 to 1 per channel
    float shininess = 0.2f;     ///< 0 to 1, as in X3D
    float transparency = 0.0f;  ///< 0 opaque to 1 clear
    std::string name;           ///< empty: none

    bool emits() const { return emissive.r > 0 || emissive.g > 0 || emissive.b > 0; }
};

/// A planar polygon of the scene, before it is cut into patches.
struct Face {
    std::vector<int> corners;  ///< indices of its vertices, counter-clockwise seen from the front
    std::shared_ptr<const Material> material;
    bool twoSided = false;     ///< seen from its back too (X3D: solid="false"); light leaves the front alone
    Location where;            ///< where it was read, for messages
    float creaseAngle = 0.0f;  ///< radians: neighbours at a smaller angle are shaded as one curved surface; 0: none
};

}  // namespace radlab
