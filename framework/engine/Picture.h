#pragma once

#include "base/Image.h"
#include "engine/CameraRays.h"
#include "engine/Parallel.h"
#include "engine/PatchShading.h"
#include "engine/TracedScene.h"

namespace radlab::engine {

/// Which pixels take more than one ray.
enum class Antialiasing {
    off,
    adaptive,    ///< those where a neighbour shows another face, or a colour that differs by more than a few percent,
                 ///< and those that show a specular lobe
    everywhere,  ///< all
};

struct PictureOptions {
    Antialiasing antialiasing = Antialiasing::adaptive;
    int samplesPerEdge = 4;  ///< of a pixel that takes more than one ray: the square of it in all; 1 or more
    int lobeSamples = 16;    ///< rays that each sample spreads over a specular lobe that the camera sees; 1 or more
    Progress progress =
        {};  ///< counts tiles, and once more those that are gone through again for pixels that take more rays
};

/// What a picture took.
struct PictureReport {
    std::size_t rays = 0;
    std::size_t sampledMore = 0;  ///< pixels that took more than one ray
    std::size_t gathers = 0;      ///< samples that meet a specular or transparent material first; 0 where none is seen
    double seconds = 0.0;
    bool stopped = false;  ///< by Ctrl-C: some pixels that were chosen took one ray all the same
};

/// The picture of a solved scene, by rays from the camera.
///
/// A point shows its radiosity over π. Where its material is specular or transparent, rays follow the mirror direction,
/// the lobe and the line of sight from surface to surface, at most 16 deep and while they carry a thousandth of the
/// light, and bring back the radiosities that they meet. The camera sees fronts only, so that rooms are looked into
/// through their walls; what it sees in a mirror has backs, and these are black. Light that a mirror would send on to
/// matt surfaces is not in the picture unless it is in the radiosities.
///
/// Every pixel takes a ray through its centre first; those that `antialiasing` chooses take a grid of rays instead, no
/// two of them in one column or row.
///
/// Ctrl-C leaves a picture whose pixels all have one ray at least.
///
/// @return linear radiance, width x height; the same to the bit for any number of threads
/// @cost   a ray a pixel and the square of samplesPerEdge for those that are chosen, on all cores; more where light is
///         gathered
/// Errors: Interrupted where some pixel has none.
/// @source [Whitted1980] following mirrors, sampling pixels more where they differ; [Chiu1994] the grid
Image drawPicture(const TracedScene& scene, const PatchShading& shading, const Frame& frame,
                  const PictureOptions& options = {}, PictureReport* report = nullptr);

}  // namespace radlab::engine
