#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "engine/Geometry.h"
#include "engine/RayScene.h"
#include "engine/Shafts.h"
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
    /// Shafts decide which pairs are clear or hidden. For others, rays join points spread over both patches, each
    /// weighted by what it would carry, and weakened by each pane that it passes. Where more than 12 pieces of faces
    /// stand between, the first 16 rays decide if they agree, and run in floats: there, what hides or leaves less
    /// than a sixteenth may be missed. Elsewhere the error is that of all rays, about 1/(2√rays) at most and
    /// mostly far less.
    ///
    /// @cost pairs that shafts decide: no ray; others: `most` rays, or 16 where many faces stand between and they agree
    double visibleShare(std::size_t first, std::size_t second) const { return visibleShare(first, second, mostRays); }
    /// The same with another number of rays for a pair that is partly hidden.
    double visibleShare(std::size_t first, std::size_t second, std::size_t rays) const;

    /// What is known of a pair without a ray.
    Sight sight(std::size_t first, std::size_t second) const;
    /// The same, and what stands between where the answer is `partly`; some of it, where that is much.
    Sight sight(std::size_t first, std::size_t second, Blockers& between) const;

    /// The share that gets past what sight() found between two patches, or between larger ones that these are parts of.
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
    Shafts shafts;
    std::unique_ptr<RayScene> scene;  // where many faces may stand between two patches
    std::vector<AreaSampler> samplers;
    mutable std::atomic<std::size_t> traced{0};
};

}  // namespace radlab::engine
