#pragma once

#include "apps/RenderSolution.h"

namespace radlab {

/// Solves a scene by links between clusters of patches.
///
/// @param threshold a link that carries a larger share of the light is refined
RenderSolution solveByLinks(const SceneInput& input, double threshold);

/// When a program was told to stop shooting.
struct ShootingFlags {
    double unshot = 0.0;    ///< share of the emitted light; 0: not told
    std::size_t shots = 0;  ///< 0: not told

    bool given() const { return unshot > 0.0 || shots > 0; }
};

/// Adds --unshot and --shots to a program's flags.
void addShootingFlags(CLI::App& app, ShootingFlags& flags);

/// Solves a scene by progressive refinement, with a progress bar; what is unshot becomes ambient light of the picture.
RenderSolution solveByShooting(const SceneInput& input, engine::FormFactorOptions options, const ShootingFlags& flags);

}  // namespace radlab
