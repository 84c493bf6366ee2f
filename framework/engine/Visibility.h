#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
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
    /// @param seed chooses other rays
    Visibility(const Geometry& geometry, std::size_t most, std::uint64_t seed = 0);

    /// The share of the unoccluded exchange between two patches that gets through, 0 to 1.
    ///
    /// Rays join points spread over both patches, each weighted by what it would carry, and weakened by each pane that
    /// it passes. With more than Shafts::mostFaces faces, where nothing is known of a pair beforehand, the first 16
    /// rays decide where they agree: an occluder that hides less than a sixteenth may be missed.
    ///
    /// @cost pairs that see everything or nothing: no ray; others: `most` rays, each against the few faces between them;
    ///       with many faces 16 rays for every pair, and `most` where these disagree
    double visibleShare(std::size_t first, std::size_t second) const { return visibleShare(first, second, mostRays); }
    /// The same with another number of rays for a pair that is partly hidden.
    double visibleShare(std::size_t first, std::size_t second, std::size_t rays) const;

    /// What is known of a pair without a ray.
    Sight sight(std::size_t first, std::size_t second) const;
    /// The same, and what stands between.
    Sight sight(std::size_t first, std::size_t second, Blockers& between) const;

    /// The share that gets past what is known to stand between two patches, or between larger ones that these are parts of.
    ///
    /// @param rays that are cast, whatever they meet
    double sharePast(const Blockers& between, std::size_t first, std::size_t second, std::size_t rays) const;

    /// How many rays were traced so far.
    std::size_t rays() const { return traced; }

private:
    template <class Share>
    double shareByRays(std::size_t first, std::size_t second, std::size_t most, std::size_t deciding,
                       const Share& share) const;

    const Geometry& geometry;
    std::size_t mostRays;
    std::uint64_t firstKey;
    std::unique_ptr<Shafts> shafts;   // where there are few faces,
    std::unique_ptr<RayScene> scene;  // and where there are many
    std::vector<AreaSampler> samplers;
    mutable std::atomic<std::size_t> traced{0};
};

}  // namespace radlab::engine
