#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "engine/TracedScene.h"

namespace radlab::engine {

/// The patches that emit, to be drawn by their power.
///
/// A surface may look for them in two ways: by directions that its reflection draws, and by points drawn on them. Both
/// are weighted by the balance heuristic, so that what they find adds up to the light, and neither finds more than it.
///
/// @source [VeachGuibas1995] balance heuristic
class Emitters {
public:
    /// @pre the scene outlives this
    explicit Emitters(const TracedScene& scene);

    /// The share of its emission that counts where a direction meets an emitter.
    ///
    /// @param density with which the direction was drawn, by solid angle; 0 where it was the only one
    /// @return 1 where the patch does not emit
    double weight(double density, const Point& from, const Point& direction, const SurfacePoint& met) const;

    /// The radiance that a surface reflects of a point drawn on an emitter, for two numbers from 0 to 1.
    ///
    /// @param reflection Reflection(towards): that of the surface, of light from a direction that leaves it
    template <class ReflectionTowards>
    Point reflected(std::size_t patch, const Point& point, double u, double v,
                    const ReflectionTowards& reflection) const;

private:
    struct Drawn {
        std::size_t patch;
        Point position;
    };

    Drawn draw(double u, double v) const;

    const TracedScene& scene;
    std::vector<std::size_t> patches;
    std::vector<AreaSampler> samplers;
    Shares shares;                  // of their power
    std::vector<double> densities;  // of each patch of the scene: with which a point of it is drawn, by area
};

template <class ReflectionTowards>
Point Emitters::reflected(std::size_t patch, const Point& point, double u, double v,
                          const ReflectionTowards& reflection) const {
    if (patches.empty()) return Point(0.0);
    const Drawn drawn = draw(u, v);
    const Point between = drawn.position - point;
    const double square = glm::dot(between, between), distance = std::sqrt(square);
    const double away = -glm::dot(between, scene.patches()[drawn.patch].normal);
    if (drawn.patch == patch || !(away > 0.0)) return Point(0.0);
    const Reflection here = reflection(between / distance);
    if (!(here.value > 0.0)) return Point(0.0);
    const double cosine = away / distance,
                 share = here.value * cosine / (here.density * cosine + densities[drawn.patch] * square);
    return share * scene.transmittance(point, drawn.position, patch, drawn.patch) *
           scene.scattering(drawn.patch).emission * std::numbers::inv_pi;
}

}  // namespace radlab::engine
