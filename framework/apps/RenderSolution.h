#pragma once

#include <string>
#include <vector>

#include "apps/SceneInput.h"
#include "engine/FormFactors.h"
#include "engine/Radiosity.h"

namespace radlab {

/// What a solution took, so that what is off can be seen to take nothing.
struct SolutionCounts {
    std::size_t shadowRays = 0, specularRays = 0, iterations = 0;
    int channels = 0;
};

/// The light of a scene's patches, and how it was found.
struct RenderSolution {
    engine::Surfaces surfaces;
    std::vector<engine::Point> radiosity;      ///< W/m² per channel
    std::vector<engine::Point> standardError;  ///< of each radiosity; empty where form factors were used
    engine::Point ambient{0.0};  ///< W/m² that pictures add to what falls on every patch: light still under way
    SolutionCounts counts;
    std::string summary;  ///< for the user, in lines
};

/// Where Ctrl-C stopped a solution, and what that means, to add to a summary; nothing where it did not.
std::string stopText(bool stopped, double residual);

/// Solves a scene by form factors between its patches.
RenderSolution solveByFormFactors(const SceneInput& input, const engine::FormFactorOptions& options);

/// The same where fewer paths were taken than were asked for.
std::string fewerText(std::size_t taken, std::size_t asked);

/// Finds the radiosities by so many random walks from each patch, with a progress bar.
RenderSolution solveByPaths(const SceneInput& input, std::size_t samples);

}  // namespace radlab
