#pragma once

#include <cstdint>

#include "engine/Emitters.h"
#include "engine/PatchShading.h"
#include "engine/TracedScene.h"

namespace radlab::engine {

/// What a camera sees in a direction.
struct Gathered {
    Point radiance{0.0};
    bool overLobe = false;  ///< the mean of samples over a specular lobe is in it
};

/// The radiance that a camera sees in a solved scene, gathered over mirrors and through panes.
class Gather {
public:
    /// @param samples rays over a lobe that the camera sees
    Gather(const TracedScene& tracedScene, const PatchShading& patchShading, const Point& behindAll, int samples)
        : scene(tracedScene),
          shading(patchShading),
          emitters(tracedScene),
          background(behindAll),
          lobeSamples(static_cast<std::size_t>(samples)) {}

    /// The radiance that comes from a point, or of the background where there is none.
    ///
    /// @param direction of the ray from the camera that met the point from its front
    /// @param key       of the pixel, which the directions over lobes depend on
    /// @param number    of the sample in the pixel: their directions fill the lobe evenly together
    Gathered radiance(const SurfacePoint& seen, const Point& direction, std::uint64_t key, std::size_t number) const;

private:
    // A ray that carries a share of the light to the camera.
    struct Sight {
        Point direction;
        double share = 1.0;
        int depth = 0;
        bool straight = true;  // from the camera
        std::uint64_t key;
        std::size_t number;
        bool* overLobe;
        double density = 0.0;  // with which the last lobe drew its direction, 0 for mirrors and the camera,
        Point lobeAt{0.0};     // and its place
    };

    Point from(const SurfacePoint& seen, const Sight& sight) const;
    Point reflected(const SurfacePoint& seen, const Sight& sight, const Scattering& scattering) const;
    Point overLobe(const SurfacePoint& seen, const Sight& sight, const Scattering& scattering) const;
    Point along(const SurfacePoint& start, Sight sight) const;

    const TracedScene& scene;
    const PatchShading& shading;
    Emitters emitters;
    Point background;
    std::size_t lobeSamples;
};

}  // namespace radlab::engine
