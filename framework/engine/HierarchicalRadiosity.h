#pragma once

#include <functional>

#include "engine/PatchTree.h"
#include "engine/Radiosity.h"

namespace radlab::engine {

struct HierarchicalOptions {
    double threshold = 1e-5;           ///< a link that carries more than this share of all emitted light is refined
    bool occlusion = true;             ///< whether anything may hide anything
    bool indirect = true;              ///< follow light that was reflected, as SolverOptions
    std::size_t rays = 16;             ///< for each link between clusters that see part of each other
    double tolerance = 1e-3;           ///< of the relative error of what a link carries unhidden
    ChannelExchange further = {};      ///< what patches exchange beside that, such as light over mirrors
    std::optional<Channels> channels;  ///< to solve; else the fewest that give all three
    std::function<void(std::size_t links)> progress;  ///< told how many links there are, now and then
};

struct HierarchicalReport {
    std::size_t links = 0;
    std::size_t rays = 0;
    std::size_t rounds = 0;  ///< of solving, and of refining by what was found
    int channels = 0;        ///< that had to be solved
    double residual = 0.0;   ///< of the light that the last round found, as in SolverReport
    bool stopped = false;    ///< by Ctrl-C: the light is that of the last round, and was not gathered once more
    double seconds = 0.0;
};

/// The radiosity of every patch, by links between clusters of patches instead of pairs of patches.
///
/// A link stands for all pairs of patches of its two clusters, which lie on different faces. It is refined, the larger cluster
/// giving way to its halves, while it carries much: B·F·A of the sender, times the receiver's reflectance. Links are first
/// refined for the light that is emitted, then for the light that was found, until none is left to refine. What they carry is
/// reciprocal, so that conjugate gradients solve for the patches' radiosities. In the end each patch gathers once more, with form factors of its
/// own to the other ends of its clusters' links. With a threshold of 0 the links are all pairs of patches.
/// Ctrl-C leaves what the last round has found.
///
/// @return W/m² per channel, in the order of the patches; the same bits for any number of threads
/// @cost   about 20 links a patch at a threshold that suits their number, and memory in proportion; a link between
///         every two faces at least
/// Errors: those of solveRadiosity; more memory than there is; Interrupted in the first round.
/// @source [Hanrahan1991]
std::vector<Point> solveHierarchical(const Geometry& geometry, const Surfaces& surfaces,
                                     const HierarchicalOptions& options = {}, HierarchicalReport* report = nullptr);

}  // namespace radlab::engine
