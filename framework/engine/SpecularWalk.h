#pragma once

#include <vector>

#include "engine/RandomNumbers.h"
#include "engine/TracedScene.h"

namespace radlab::engine {

/// Whether a face shows light of its own radiosity.
inline bool isSeen(const Scattering& scattering) {
    return scattering.emission != Point(0.0) || scattering.diffuse != Point(0.0);
}

/// The share of a ray that arrives at a patch.
struct Arrival {
    std::size_t patch;
    Point share;
};

/// A ray of light on its way over specular faces and through panes.
///
/// @source [ArvoKirk1990] Russian roulette
class SpecularWalk {
public:
    /// @param key    of its patch, and number of the ray, which its random numbers depend on
    /// @param arrivals where it adds what arrives, over one specular face at least, at patches that are seen
    SpecularWalk(const TracedScene& tracedScene, std::uint64_t key, std::size_t number, std::vector<Arrival>& arrivals)
        : scene(tracedScene), random(key, number), found(arrivals) {}

    /// Follows light that leaves a patch.
    void follow(const SurfacePoint& start, const Point& direction) { follow({start, direction, Point(1.0), 0, false}); }

private:
    struct Ray {
        SurfacePoint start;
        Point direction;
        Point share;
        int depth;
        bool reflected;
    };

    void follow(Ray ray);
    void reflect(const Ray& ray, const SurfacePoint& met);
    bool survives(Point& share);

    const TracedScene& scene;
    RandomNumbers random;
    std::vector<Arrival>& found;
};

}  // namespace radlab::engine
