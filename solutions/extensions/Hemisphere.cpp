// Extension 1, solved: form factors by rays over the hemisphere.

#include "Extensions.h"

// Evenly from the unit disc: the root, since a ring twice as far out has twice the area. Lifted up, the disc's even
// density becomes cosθ/π on the hemisphere, as each piece of it covers cosθ of its own area below.
static Vec3f cosineDirection(RandomNumbers& random) {
    const float r2 = random.next(), turn = 2.0f * static_cast<float>(M_PI) * random.next();
    const float r = std::sqrt(r2);
    return {r * std::cos(turn), r * std::sin(turn), std::sqrt(1.0f - r2)};
}

// From a hemisphere over the z axis to the one over the normal; the first axis is one that the normal is not along.
static Vec3f turnedTo(const Vec3f& normal, const Vec3f& direction) {
    const Vec3f away = std::abs(normal.x) < 0.5f ? Vec3f(1.0f, 0.0f, 0.0f) : Vec3f(0.0f, 1.0f, 0.0f);
    const Vec3f right = normalize(cross(away, normal));
    const Vec3f up = cross(normal, right);
    return direction.x * right + direction.y * up + direction.z * normal;
}

MyPolygon* hemisphereFF(const RayCaster& scene, int rays, RandomNumbers& random) {
    for (MyPolygon* patch : polygons) patch->formF = 0.0f;
    MyPolygon* shooter = maxenergy_patch();
    if (!shooter) return nullptr;

    for (int i = 0; i < rays; ++i) {
        const Vec3f direction = turnedTo(shooter->normal, cosineDirection(random));
        if (MyPolygon* patch = scene.hit(shooter->center, direction, shooter)) patch->formF += 1.0f;
    }
    for (MyPolygon* patch : polygons) patch->formF /= static_cast<float>(rays);
    return shooter;
}
