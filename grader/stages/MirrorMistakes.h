#pragma once

#include <functional>
#include <string>
#include <vector>

#include "course/MirrorPass.h"

namespace radlab::grader {

/// The mirror that mirrorScene is told of.
struct MirrorPlane {
    Vec3f point, normal, reflectance;
};

/// How a program goes about it.
struct MirrorWay {
    std::function<glm::mat4(const MirrorPlane& plane)> world;  ///< by default the reflection
    std::function<glm::vec4(const MirrorPlane& plane)> clip;   ///< by default keeps what lies in front
    bool clockwise = true;
    bool everywhere = false;  ///< in all pixels, not in those of the mirror alone
    /// What a pixel becomes of what it holds and what the second picture has there; by default with the reflectance
    /// added.
    std::function<Vec3f(const MirrorPlane& plane, const Vec3f& held, const Vec3f& seen)> combined;

    glm::mat4 worldFor(const MirrorPlane& plane) const;
    glm::vec4 clipFor(const MirrorPlane& plane) const;
    Vec3f combine(const MirrorPlane& plane, const Vec3f& held, const Vec3f& seen) const;
};

/// A misconception of mirrorScene.
struct MirrorMistake {
    std::string id, text, hint;
    MirrorWay way;
};

/// What people do in place of the right thing; special mistakes before general ones.
std::vector<MirrorMistake> mirrorMistakes();

}  // namespace radlab::grader
