#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "engine/ExchangeArea.h"
#include "engine/PatchTree.h"
#include "engine/Radiosity.h"
#include "engine/Visibility.h"

namespace radlab::engine {

/// What two nodes of a tree exchange, as one number for all their pairs of patches.
struct Link {
    std::uint32_t a = 0, b = 0;
    Sight sight = Sight::clear;  ///< clear or partly: hidden pairs have no link
    double exchange = 0.0;       ///< the direct exchange area, with nothing between them
    double share = 1.0;          ///< of it that gets past what stands between them
};

/// Links between nodes of different faces: each pair of patches is in one of them at most, and in none where nothing is exchanged.
class Links {
public:
    struct Options {
        bool occlusion = true;
        std::size_t rays = 16;
        double tolerance = 1e-3;
    };

    /// Links every two faces.
    ///
    /// @param tree  lives as long as this does
    Links(const PatchTree& tree, const Options& options);

    /// Splits links, and those that come out of them, while they are wanted finer and are not between two patches.
    ///
    /// @return whether any was split
    /// Where Interrupted ends it, no links are left.
    bool refine(const std::function<bool(const Link&)>& wantedFiner);

    const std::vector<Link>& list() const { return links; }
    std::size_t rays() const { return visibility ? visibility->rays() : 0; }

    /// What the links carry between patches, as they stand now.
    Transport transport() const;

    /// What arrives at each patch through the links of its clusters, each taken with the patch's own form factor and visibility:
    /// so what a cluster gets evenly falls on its patches as it should.
    ///
    /// @param radiosity of the patches, W/m²
    /// @return W/m² for each patch
    /// @cost   a form factor for each link of each patch's clusters, and about 100 rays for each patch that has hidden ones
    std::vector<Point> gathered(const std::vector<Point>& radiosity) const;

private:
    class Gathering;
    struct Pair {
        std::uint32_t a, b;
        Sight sight;  // of what they were split from
    };

    bool isFinal(const Link& link) const { return tree.isLeaf(link.a) && tree.isLeaf(link.b); }
    std::array<Pair, 2> halves(const Link& link) const;
    double unhidden(std::uint32_t a, std::uint32_t b) const;
    Link measured(const Pair& pair) const;
    std::vector<Link> measured(const std::vector<Pair>& pairs) const;
    void settle(std::vector<Link>& fresh) const;

    const PatchTree& tree;
    ExchangeAreas exchanges;
    std::unique_ptr<Visibility> visibility;  // none where nothing may hide anything
    std::vector<Link> links;
};

}  // namespace radlab::engine
