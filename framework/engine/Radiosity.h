#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "course/PatchMesh.h"
#include "engine/FormFactorMatrix.h"
#include "scene/Channels.h"

namespace radlab::engine {

/// What patches emit and reflect, channel by channel.
struct Surfaces {
    std::vector<Point> emission;     ///< E in W/m², >= 0
    std::vector<Point> reflectance;  ///< ρ, 0 to 1
};

/// One channel of all patches' colours.
std::vector<double> channelOf(const std::vector<Point>& colors, int channel);

/// The surfaces of a mesh's patches.
Surfaces surfacesOf(const PatchMesh& mesh);

/// Adds to result what x sends in one channel.
using ChannelExchange = std::function<void(int channel, const std::vector<double>& x, std::vector<double>& result)>;

/// What a patch exchanges with another one: A·F, per channel.
struct PatchExchange {
    std::size_t patch;
    Point exchange;
};

/// The light that patches send each other, whatever way it is stored: the symmetric S with S_ij = A_i·F_ij.
struct Transport {
    std::vector<double> areas;
    /// Sets result to S·x; both hold a value for each patch.
    std::function<void(const std::vector<double>& x, std::vector<double>& result)> exchange;
    /// What channels differ in, such as light over coloured mirrors; none where empty.
    ChannelExchange further = {};
};

/// That of a matrix, which lives as long as this does.
Transport transportOf(const FormFactorMatrix& matrix);

struct SolverOptions {
    double tolerance = 1e-10;  ///< of the residual, relative to the light that is reflected once
    bool indirect = true;  ///< follow light that was reflected; else B = E + ρ·F·E, which is all where it is black
    std::size_t mostIterations = 1000;
    std::optional<Channels> channels;  ///< to solve; else the fewest that give all three
};

/// How a solution came about.
struct SolverReport {
    int channels = 0;            ///< that had to be solved; the others are dark, or multiples of these
    std::size_t iterations = 0;  ///< of the channel that took most
    double residual = 0.0;       ///< the largest that is left, relative as the tolerance is
    bool stopped = false;        ///< by Ctrl-C, with a residual above the tolerance
};

/// The radiosity of every patch: B = E + ρ·F·B.
///
/// Solves for the reflected part by conjugate gradients, on the system that reciprocity makes symmetric: with
/// S = A·F, y = √(A/ρ)·(B - E) obeys y - √(ρ/A)·S·√(ρ/A)·y = √(ρ/A)·S·E. Black patches drop out by themselves. A channel
/// that is dark or a multiple of another one is not solved (channelsOf). Ctrl-C leaves what the iterations so far have found.
///
/// @return W/m² per channel, >= 0 up to the tolerance, in the order of the patches
/// @cost   each iteration is one exchange, 13 to 15 of them at ρ = 0.99; the same bits for any number of threads
/// Errors: an exchange that is not reciprocal (makeReciprocal); reflectances so near 1 in a scene so closed, or rows that add up to so much above 1, that light never ends: told with
///         the patch; no convergence within mostIterations; Interrupted before the first iteration.
/// @source [CohenWallace1993, chapter 5] the system
std::vector<Point> solveRadiosity(const Transport& transport, const Surfaces& surfaces,
                                  const SolverOptions& options = {}, SolverReport* report = nullptr);
std::vector<Point> solveRadiosity(const FormFactorMatrix& matrix, const Surfaces& surfaces,
                                  const SolverOptions& options = {}, SolverReport* report = nullptr);

}  // namespace radlab::engine
