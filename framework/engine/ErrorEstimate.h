#pragma once

#include <cstddef>
#include <vector>

#include "engine/Geometry.h"
#include "engine/Radiosity.h"
#include "engine/Scattering.h"

namespace radlab::engine {

struct ErrorEstimateOptions {
    std::size_t samples = 128;                 ///< patches whose light is gathered again
    std::size_t rays = 64;                     ///< for each pair that is partly hidden
    bool occlusion = true;                     ///< whether anything may hide anything
    std::vector<Scattering> scatterings = {};  ///< of each face, where light over specular ones counts; else none
    std::size_t specularRays = 4096;           ///< as SpecularOptions::rays
};

/// The relative error of radiosities of a mesh, whatever method they came from, without knowing better ones.
///
/// Some patches, each standing for the same area, gather the light of all others once more with exact form factors,
/// and with other rays over specular faces. By how much that differs from what they have is the residual. Where it is
/// without pattern, later reflections average it out; its mean over the scene is reflected on, and counts 1/(1-ρ)
/// times.
///
/// @return RMS of the error over RMS of the radiosity, both weighted by area, the channels added up; 0 for a black scene
/// @cost   a row of form factors for each sample; where faces are specular, the rays of samples and emitters
double estimateError(const Geometry& geometry, const Surfaces& surfaces, const std::vector<Point>& radiosity,
                     const ErrorEstimateOptions& options = {});

}  // namespace radlab::engine
