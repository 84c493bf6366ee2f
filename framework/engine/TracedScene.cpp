#include "engine/TracedScene.h"

#include <cmath>

#include "base/Error.h"

namespace radlab::engine {

namespace {

// The distance of a plane along a ray in doubles; that of the floats where the ray grazes the plane.
double refined(const RayHit& hit, const Polygon& patch, const Point& from, const Point& direction) {
    constexpr double floats = 1e-3;
    const double exact = glm::dot(patch.center - from, patch.normal) / glm::dot(direction, patch.normal);
    return std::abs(exact - hit.distance) <= floats * hit.distance ? exact : hit.distance;
}

}  // namespace

TracedScene::TracedScene(const Geometry& shapes, std::vector<Scattering> ofFaces)
    : geometry(shapes), scatterings(std::move(ofFaces)), rayScene(shapes.patches) {
    RADLAB_CHECK(scatterings.size() == shapes.faces.size());
    if (throughOf(scatterings).empty()) return;
    for (const std::size_t face : shapes.faceOf) through.push_back(scatterings[face].through);
}

SurfacePoint TracedScene::meet(const Point& from, const Point& direction, std::size_t start, Sides sides) const {
    const RayHit hit = rayScene.meet(from, direction, start, sides);
    if (hit.polygon == RayHit::nothing) return {};
    const Polygon& patch = geometry.patches[hit.polygon];
    return {hit.polygon, from + refined(hit, patch, from, direction) * direction,
            glm::dot(direction, patch.normal) < 0.0};
}

double TracedScene::transmittance(const Point& from, const Point& to, std::size_t first, std::size_t second) const {
    return rayScene.transmittance(from, to, first, second, through);
}

}  // namespace radlab::engine
