#pragma once

#include <vector>

#include "engine/Geometry.h"
#include "engine/RayScene.h"
#include "engine/Shaft.h"
#include "engine/Triangles.h"

namespace radlab::engine {

/// How much of their light two patches exchange past what stands between them.
class Visibility {
public:
    /// @param most rays for a pair that is partly hidden, at least 16
    Visibility(const Geometry& geometry, std::size_t most);

    /// The share of the unoccluded exchange between two patches that gets through, 0 to 1.
    ///
    /// Rays join points spread over both patches, each weighted by what it would carry. Where the first 16 agree, they decide: an
    /// occluder that hides less than a sixteenth may be missed.
    ///
    /// @cost nothing but the shaft's test where nothing stands between them; else 16 rays, or `most` where these disagree
    double visibleShare(std::size_t first, std::size_t second) const;

    std::size_t rays() const { return scene.rays(); }

private:
    const Geometry& geometry;
    std::size_t mostRays;
    Shafts shafts;
    RayScene scene;
    std::vector<AreaSampler> samplers;
};

}  // namespace radlab::engine
