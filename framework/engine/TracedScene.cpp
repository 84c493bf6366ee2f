#include "engine/TracedScene.h"

#include <algorithm>
#include <cmath>

#include "base/Error.h"

namespace radlab::engine {

namespace {

constexpr int mostPanes = 64;  // on one line; what more let through is nothing to speak of

// The distance of a plane along a ray in doubles; that of the floats where the ray grazes the plane.
double refined(const RayHit& hit, const Polygon& patch, const Point& from, const Point& direction) {
    constexpr double floats = 1e-3;
    const double exact = glm::dot(patch.center - from, patch.normal) / glm::dot(direction, patch.normal);
    return std::abs(exact - hit.distance) <= floats * hit.distance ? exact : hit.distance;
}

}  // namespace

TracedScene::TracedScene(const Geometry& shapes, std::vector<Scattering> ofFaces)
    : geometry(shapes),
      scatterings(std::move(ofFaces)),
      rayScene(shapes.patches),
      opaque(
          std::all_of(scatterings.begin(), scatterings.end(), [](const Scattering& s) { return s.through == 0.0; })) {
    RADLAB_CHECK(scatterings.size() == shapes.faces.size());
}

SurfacePoint TracedScene::meet(const Point& from, const Point& direction, std::size_t start, Sides sides) const {
    const RayHit hit = rayScene.meet(from, direction, start, sides);
    if (hit.polygon == RayHit::nothing) return {};
    const Polygon& patch = geometry.patches[hit.polygon];
    return {hit.polygon, from + refined(hit, patch, from, direction) * direction,
            glm::dot(direction, patch.normal) < 0.0};
}

double TracedScene::transmittance(const Point& from, const Point& to, std::size_t first, std::size_t second) const {
    if (opaque) return rayScene.hides(from, to, first, second) ? 0.0 : 1.0;
    const double length = glm::length(to - from);
    const Point direction = (to - from) / length;
    SurfacePoint at{first, from, true};
    double share = 1.0;
    for (int pane = 0; pane < mostPanes; ++pane) {
        at = meet(at.position, direction, at.patch, Sides::both);
        if (!at.exists()) return share;
        if (at.patch == second || glm::length(at.position - from) >= length) return share;
        share *= scattering(at.patch).through;
        if (share == 0.0) return 0.0;
    }
    return share;
}

}  // namespace radlab::engine
