#pragma once

#include <functional>
#include <vector>

#include "course/DataFormat.h"
#include "course/MirrorPass.h"

namespace radlab {

/// Draws patches in their colours, by a ray through the centre of each pixel; black where none is seen.
class RayMirrorPass : public MirrorPass {
public:
    using IsMirror = std::function<bool(const MyPolygon* patch)>;

    /// @param patches, corners  as the course's globals; they have to outlive the pass
    /// @param isMirror          which patches are a mirror's front
    /// @param clipFromWorld     the camera, as OpenGL takes it, in perspective
    /// @param width, height     of the picture, in pixels
    RayMirrorPass(const std::vector<MyPolygon*>& patches, const std::vector<MyVertex*>& corners, IsMirror isMirror,
                  const glm::mat4& clipFromWorld, int width, int height);

    bool showsMirror(int x, int y) const override;
    Image draw(const glm::mat4& world, const glm::vec4& clip, bool clockwise) const override;

    /// The same with rays through another point of each pixel than its centre (0.5, 0.5).
    Image drawAt(const Vec3f& inPixel, const glm::mat4& world, const glm::vec4& clip, bool clockwise) const;

    /// The first pass: the scene as it is.
    Image first() const;

private:
    const std::vector<MyPolygon*>& polygons;
    const std::vector<MyVertex*>& vertices;
    glm::mat4 camera;
    int width, height;
    std::vector<bool> mirror;  // by pixel
};

}  // namespace radlab
