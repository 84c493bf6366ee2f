#pragma once

#include "course/PictureView.h"
#include "course/RayCaster.h"

namespace radlab {

/// Patches in their colours as a camera sees them, found by rays; black where there is none.
class RayView : public PictureView {
public:
    /// @param scene          has to outlive the view
    /// @param clipFromWorld  the camera, as OpenGL takes it
    /// @param width, height  of the picture, in pixels
    /// @param exposure       as in toneMap
    RayView(const RayCaster& scene, const glm::mat4& clipFromWorld, int width, int height, float exposure);

    Vec3f radiance(float x, float y) const override;
    Vec3f display(const Vec3f& radiance) const override;

    /// The patch that is seen at a point of the picture, or nullptr.
    const MyPolygon* patchAt(float x, float y) const;

private:
    const RayCaster& scene;
    glm::dmat4 worldFromClip;
    double width, height;
    float exposure;
};

}  // namespace radlab
