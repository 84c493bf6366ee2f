#include "engine/Emitters.h"

#include <algorithm>

namespace radlab::engine {

Emitters::Emitters(const TracedScene& tracedScene) : scene(tracedScene), densities(scene.patches().size(), 0.0) {
    double sum = 0.0;
    for (std::size_t i = 0; i < densities.size(); ++i) {
        const Point& emission = scene.scattering(i).emission;
        densities[i] = emission.r + emission.g + emission.b;
        const double power = densities[i] * scene.patches()[i].area;
        if (!(power > 0.0)) continue;
        patches.push_back(i);
        samplers.emplace_back(scene.patches()[i]);
        upTo.push_back(sum += power);
    }
    for (double& share : upTo) share /= sum;
    for (double& density : densities) density = sum > 0.0 ? density / sum : 0.0;
}

double Emitters::weight(double density, const Point& from, const Point& direction, const SurfacePoint& met) const {
    if (density == 0.0 || densities[met.patch] == 0.0) return 1.0;
    const Point between = met.position - from;
    const double found = -density * glm::dot(direction, scene.patches()[met.patch].normal);
    return found / (found + densities[met.patch] * glm::dot(between, between));
}

Emitters::Drawn Emitters::draw(double u, double v) const {
    const auto found = std::upper_bound(upTo.begin(), upTo.end() - 1, u);
    const double before = found == upTo.begin() ? 0.0 : *(found - 1);
    const auto which = static_cast<std::size_t>(found - upTo.begin());
    return {patches[which], samplers[which].at(std::clamp((u - before) / (*found - before), 0.0, 1.0), v)};
}

}  // namespace radlab::engine
