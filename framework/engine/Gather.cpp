#include "engine/Gather.h"

#include <numbers>

#include "engine/LowDiscrepancy.h"
#include "engine/RandomNumbers.h"

namespace radlab::engine {

namespace {

constexpr int deepest = 16;
constexpr double leastShare = 1e-3;

}  // namespace

Gathered Gather::radiance(const SurfacePoint& seen, const Point& direction, std::uint64_t key,
                          std::size_t number) const {
    Gathered gathered;
    gathered.radiance = from(seen, {direction, 1.0, 0, true, key, number, &gathered.overLobe, 0.0, Point(0.0)});
    return gathered;
}

Point Gather::from(const SurfacePoint& seen, const Sight& sight) const {
    if (!seen.exists()) return sight.straight ? background : Point(0.0);
    const Scattering& scattering = scene.scattering(seen.patch);
    Point radiance(0.0);
    if (seen.front) {
        const double drawn = 1.0 - emitters.weight(sight.density, sight.lobeAt, sight.direction, seen);
        radiance = shading.radiosityAt(seen.patch, seen.position) - drawn * scattering.emission;
        radiance = glm::max(radiance, Point(0.0)) * std::numbers::inv_pi;
        if (scattering.isSpecular()) radiance += scattering.specular * reflected(seen, sight, scattering);
    }
    if (scattering.through > 0.0) {
        Sight on = sight;
        on.share *= scattering.through;
        radiance += scattering.through * along(seen, on);
    }
    return radiance;
}

Point Gather::reflected(const SurfacePoint& seen, const Sight& sight, const Scattering& scattering) const {
    if (!scattering.mirror) return overLobe(seen, sight, scattering);
    Sight on = sight;
    on.direction = mirrored(sight.direction, scene.patches()[seen.patch].normal);
    on.share *= largest(scattering.specular);
    on.straight = false;
    on.density = 0.0;
    return along(seen, on);
}

// Many directions from the first surface, one from each that these lead to, and as many points of emitters.
Point Gather::overLobe(const SurfacePoint& seen, const Sight& sight, const Scattering& scattering) const {
    const std::size_t count = sight.depth == 0 ? lobeSamples : 1;
    *sight.overLobe = true;
    const Point& normal = scene.patches()[seen.patch].normal;
    const auto reflection = [&](const Point& towards) {
        return lobeReflection(sight.direction, normal, scattering.exponent, towards);
    };
    const LowDiscrepancy points(sight.key);
    Point sum(0.0);
    for (std::size_t k = 0; k < count; ++k) {
        Sight on = sight;
        on.number = sight.number * count + k;
        const auto at = points.at(on.number);
        sum += emitters.reflected(seen.patch, seen.position, at[2], at[3], reflection);
        const LobeDirection lobe = lobeDirection(sight.direction, normal, scattering.exponent, at[0], at[1]);
        if (lobe.weight == 0.0) continue;
        on.direction = lobe.direction;
        on.share *= lobe.weight * largest(scattering.specular);
        on.straight = false;
        on.density = reflection(lobe.direction).density;
        on.lobeAt = seen.position;
        sum += lobe.weight * along(seen, on);
    }
    return sum / static_cast<double>(count);
}

Point Gather::along(const SurfacePoint& start, Sight sight) const {
    if (++sight.depth > deepest || sight.share < leastShare) return Point(0.0);
    sight.key = mixedBits(sight.key);
    const Sides sides = sight.straight ? Sides::fronts : Sides::both;
    return from(scene.meet(start.position, sight.direction, start.patch, sides), sight);
}

}  // namespace radlab::engine
