#include "engine/Emitters.h"

namespace radlab::engine {

Emitters::Emitters(const TracedScene& tracedScene) : scene(tracedScene), densities(scene.patches().size(), 0.0) {
    for (std::size_t i = 0; i < densities.size(); ++i) {
        const Point& emission = scene.scattering(i).emission;
        densities[i] = emission.r + emission.g + emission.b;
        const double power = densities[i] * scene.patches()[i].area;
        if (!(power > 0.0)) continue;
        patches.push_back(i);
        samplers.emplace_back(scene.patches()[i]);
        shares.add(power);
    }
    for (double& density : densities) density = shares.total() > 0.0 ? density / shares.total() : 0.0;
}

double Emitters::weight(double density, const Point& from, const Point& direction, const SurfacePoint& met) const {
    if (density == 0.0 || densities[met.patch] == 0.0) return 1.0;
    const Point between = met.position - from;
    const double found = -density * glm::dot(direction, scene.patches()[met.patch].normal);
    return found / (found + densities[met.patch] * glm::dot(between, between));
}

Emitters::Drawn Emitters::draw(double u, double v) const {
    const Shares::Drawn drawn = shares.draw(u);
    return {patches[drawn.which], samplers[drawn.which].at(drawn.rest, v)};
}

}  // namespace radlab::engine
