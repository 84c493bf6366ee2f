#pragma once

#include "base/Image.h"
#include "course/Vec3f.h"

/// What a mirror's second pass needs of the first: where the mirror is seen, and how the scene is drawn.
class MirrorPass {
public:
    virtual ~MirrorPass() = default;

    /// Whether the first pass shows the mirror at pixel (x, y), row 0 at the top.
    virtual bool showsMirror(int x, int y) const = 0;

    /// Draws the scene once more, for the same camera.
    ///
    /// First cuts away of each patch what lies where clip.x·x + clip.y·y + clip.z·z + clip.w < 0; then carries what is
    /// left by world; then draws the fronts, but not the backs, of what came out.
    ///
    /// @param world      carries each point of the scene
    /// @param clip       a plane in the scene, before anything is carried
    /// @param clockwise  fronts are where the corners go round clockwise, as in a world that is carried into its mirror
    ///                   image; else counter-clockwise, as in DataFormat.h
    /// @return radiance, of the picture's size
    virtual radlab::Image draw(const glm::mat4& world, const glm::vec4& clip, bool clockwise) const = 0;
};
