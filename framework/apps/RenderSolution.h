#pragma once

#include <string>
#include <vector>

#include "apps/SceneInput.h"
#include "engine/FormFactors.h"
#include "engine/Radiosity.h"

namespace radlab {

/// The light of a scene's patches, and how it was found.
struct RenderSolution {
    engine::Surfaces surfaces;
    std::vector<engine::Point> radiosity;      ///< W/m² per channel
    std::vector<engine::Point> standardError;  ///< of each radiosity; empty where form factors were used
    engine::Point ambient{0.0};  ///< W/m² that pictures add to what falls on every patch: light still under way
    std::string summary;         ///< for the user, in lines
};

/// Solves a scene by form factors between its patches.
RenderSolution solveByFormFactors(const SceneInput& input, const engine::FormFactorOptions& options);

/// Finds the radiosities by so many random walks from each patch, with a progress bar.
RenderSolution solveByPaths(const SceneInput& input, std::size_t samples);

}  // namespace radlab
