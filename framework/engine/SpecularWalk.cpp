#include "engine/SpecularWalk.h"

namespace radlab::engine {

namespace {

constexpr int deepest = 1000;  // what is left then, between mirrors that swallow nothing, is dropped
constexpr double little = 0.05;

}  // namespace

void SpecularWalk::follow(Ray ray) {
    while (ray.depth++ < deepest && survives(ray.share)) {
        const SurfacePoint met = scene.meet(ray.start.position, ray.direction, ray.start.patch, Sides::both);
        if (!met.exists()) return;
        const Scattering& scattering = scene.scattering(met.patch);
        if (met.front && ray.reflected && isSeen(scattering)) found.push_back({met.patch, ray.share});
        if (met.front && scattering.isSpecular()) reflect(ray, met);
        ray.start = met;
        ray.share *= scattering.through;
    }
}

void SpecularWalk::reflect(const Ray& ray, const SurfacePoint& met) {
    const Scattering& scattering = scene.scattering(met.patch);
    const Point& normal = scene.patches()[met.patch].normal;
    Ray on{met, mirrored(ray.direction, normal), ray.share * scattering.specular, ray.depth, true};
    if (!scattering.mirror) {
        const double u = random.next(), v = random.next();
        const LobeDirection lobe = lobeDirection(ray.direction, normal, scattering.exponent, u, v);
        on.direction = lobe.direction;
        on.share *= lobe.weight;
    }
    follow(on);
}

// Whether a ray that carries little goes on; its share then makes up for those that do not.
bool SpecularWalk::survives(Point& share) {
    const double most = largest(share);
    if (most >= little) return true;
    if (random.next() * little >= most) return false;
    share *= little / most;
    return true;
}

}  // namespace radlab::engine
