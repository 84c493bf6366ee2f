#pragma once

#include <cstddef>

#include "engine/FormFactors.h"
#include "scene/Effects.h"

namespace radlab::engine {

/// What there is to do in a scene, as far as it decides the cost.
struct Work {
    std::size_t patches = 0;
    double facing = 0.0;       ///< pairs of patches that see each other's front, but for what stands between them
    double touching = 0.0;     ///< those of them that are no farther apart than they are large
    double raysPerPair = 0.0;  ///< shadow rays for a facing pair, where occlusion is looked for
    double specularShare = 0.0, clearShare = 0.0;  ///< of the faces' area: mirrors, and lets light through
    double specularRays = 0.0;                     ///< that leave patches for specular faces
    std::size_t pixels = 640'000;
    FormFactorOptions options;
};

/// Counts the work in a scene, by a few of its pairs.
///
/// @pre the geometry is of this scene
/// @param options  the method asked for, which may be `automatic`; `occlusion` is not looked at
/// @return counts within some ten percent where there are many; the same for every run
/// @cost   some milliseconds
Work workOf(const Scene& scene, const Geometry& geometry, const FormFactorOptions& options);

/// What a solution and a picture are expected to take.
struct Cost {
    double formFactors = 0.0, specular = 0.0, radiosities = 0.0, picture = 0.0;  ///< seconds
    double bytes = 0.0;                                                          ///< of data, beside the program itself

    double seconds() const { return formFactors + specular + radiosities + picture; }
};

/// Predicts the cost of a scene with some effects, from unit costs that were measured once.
///
/// The units were measured on two cores with nothing else to do; another machine differs, but hardly in which of
/// two ways is the cheaper one. Solving is taken to reach a residual of 1e-10.
///
/// @return seconds within a factor of two on that machine
Cost expectedCost(const Work& work, const Effects& effects);

/// What one effect costs where it is on, or saves where it is off.
///
/// @return seconds, >= 0
double costOf(Effect effect, const Work& work, const Effects& effects);

}  // namespace radlab::engine
