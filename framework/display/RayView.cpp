#include "display/RayView.h"

#include "display/ToneMap.h"

namespace radlab {

RayView::RayView(const RayCaster& patches, const glm::mat4& clipFromWorld, int columns, int rows,
                 float displayPerRadiance)
    : scene(patches),
      worldFromClip(glm::inverse(glm::dmat4(clipFromWorld))),
      width(columns),
      height(rows),
      exposure(displayPerRadiance) {}

const MyPolygon* RayView::patchAt(float x, float y) const {
    const auto at = [&](double depth) {
        const glm::dvec4 clip(2.0 * static_cast<double>(x) / width - 1.0, 1.0 - 2.0 * static_cast<double>(y) / height,
                              depth, 1.0);
        const glm::dvec4 world = worldFromClip * clip;
        return glm::dvec3(world) / world.w;
    };
    const glm::dvec3 nearest = at(-1.0);
    return scene.hit(Vec3f(nearest), Vec3f(at(1.0) - nearest));
}

Vec3f RayView::radiance(float x, float y) const {
    const MyPolygon* patch = patchAt(x, y);
    return patch ? patch->color : Vec3f(0.0f);
}

Vec3f RayView::display(const Vec3f& radiance) const { return toneMapped(radiance, exposure); }

}  // namespace radlab
