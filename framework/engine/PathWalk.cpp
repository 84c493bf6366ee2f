#include "engine/PathWalk.h"

#include <algorithm>
#include <numbers>

#include "base/Error.h"

namespace radlab::engine {

namespace {

constexpr int sureBounces = 3, mostBounces = 1000000;

// Whether the walk goes on; its share then makes up for those that do not.
bool survives(Point& share, int bounces, RandomNumbers& random) {
    if (bounces < sureBounces) return true;
    if (bounces == mostBounces)
        throw Error("the light in this scene never ends: found a path of " + std::to_string(mostBounces) +
                    " bounces that still carries light, expected surfaces that swallow some");
    const double chance = std::min(1.0, largest(share));
    if (random.next() >= chance) return false;
    share /= chance;
    return true;
}

}  // namespace

PathWalk::PathWalk(const TracedScene& tracedScene, bool constantPatches)
    : scene(tracedScene), resampled(constantPatches), emitters(tracedScene) {
    for (const Polygon& patch : scene.patches()) samplers.emplace_back(patch);
}

Point PathWalk::radiance(const Point& eye, const Point& direction, const Point& background,
                         RandomNumbers& random) const {
    Step step;
    step.from = eye;
    step.direction = direction;
    step.straight = true;
    return follow(step, background, random);
}

Point PathWalk::arriving(std::size_t patch, const Point& point, double u, double v, RandomNumbers& random) const {
    Step step;
    leaveDiffusely(step, patch, point, u, v);
    return reflectedDiffusely(patch, point, random) + follow(step, Point(0.0), random);
}

Point PathWalk::follow(Step step, const Point& background, RandomNumbers& random) const {
    Point found(0.0);
    while (true) {
        const Sides sides = step.straight ? Sides::fronts : Sides::both;
        const SurfacePoint met = scene.meet(step.from, step.direction, step.start, sides);
        if (!met.exists()) return step.straight ? found + step.share * background : found;
        if (met.front)
            found += emitters.weight(step.density, step.bouncedAt, step.direction, met) * step.share *
                     scene.scattering(met.patch).emission * std::numbers::inv_pi;
        if (!scatter(step, met, found, random)) return found;
        if (!survives(step.share, ++step.bounces, random)) return found;
    }
}

bool PathWalk::scatter(Step& step, const SurfacePoint& met, Point& found, RandomNumbers& random) const {
    const Scattering& scattering = scene.scattering(met.patch);
    const double through = scattering.through, diffuse = met.front ? largest(scattering.diffuse) : 0.0,
                 specular = met.front ? largest(scattering.specular) : 0.0, sum = through + diffuse + specular;
    if (!(sum > 0.0)) return false;
    const double choice = sum * random.next();
    if (choice < diffuse) {
        step.share *= scattering.diffuse * (sum / diffuse);
        bounceDiffusely(step, met, found, random);
        return true;
    }
    if (choice < diffuse + specular) {
        step.share *= scattering.specular * (sum / specular);
        return bounceSpecularly(step, met, found, random);
    }
    step.share *= sum;
    step.from = met.position;
    step.start = met.patch;
    return through > 0.0;
}

void PathWalk::bounceDiffusely(Step& step, const SurfacePoint& met, Point& found, RandomNumbers& random) const {
    Point point = met.position;
    if (resampled) {
        const double u = random.next(), v = random.next();
        point = pointOf(met.patch, u, v);
    }
    found += step.share * reflectedDiffusely(met.patch, point, random);
    const double u = random.next(), v = random.next();
    leaveDiffusely(step, met.patch, point, u, v);
}

bool PathWalk::bounceSpecularly(Step& step, const SurfacePoint& met, Point& found, RandomNumbers& random) const {
    const Scattering& scattering = scene.scattering(met.patch);
    const Point& normal = scene.patches()[met.patch].normal;
    const Point arrived = step.direction;
    step.from = step.bouncedAt = met.position;
    step.start = met.patch;
    step.straight = false;
    step.density = 0.0;
    step.direction = mirrored(arrived, normal);
    if (scattering.mirror) return true;
    const auto reflection = [&](const Point& towards) {
        return lobeReflection(arrived, normal, scattering.exponent, towards);
    };
    const double onU = random.next(), onV = random.next(), u = random.next(), v = random.next();
    found += step.share * emitters.reflected(met.patch, met.position, onU, onV, reflection);
    const LobeDirection lobe = lobeDirection(arrived, normal, scattering.exponent, u, v);
    step.direction = lobe.direction;
    step.density = reflection(lobe.direction).density;
    step.share *= lobe.weight;
    return lobe.weight > 0.0;
}

void PathWalk::leaveDiffusely(Step& step, std::size_t patch, const Point& point, double u, double v) const {
    const Point& normal = scene.patches()[patch].normal;
    step.from = step.bouncedAt = point;
    step.start = patch;
    step.straight = false;
    step.direction = cosineDirection(normal, u, v);
    step.density = diffuseReflection(normal, step.direction).density;
}

Point PathWalk::reflectedDiffusely(std::size_t patch, const Point& point, RandomNumbers& random) const {
    const double u = random.next(), v = random.next();
    return emitters.reflected(patch, point, u, v, [&](const Point& towards) {
        return diffuseReflection(scene.patches()[patch].normal, towards);
    });
}

}  // namespace radlab::engine
