#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "study/StudyMethods.h"

namespace radlab::study {

/// What a study measures, and how well.
struct StudyPlan {
    std::string name;
    bool quick = false;               ///< few levels of each method
    std::size_t patches = 1000;       ///< at which all levels of all methods are measured
    std::vector<std::size_t> others;  ///< numbers of patches at which each method's usual level is measured
    std::size_t referenceRays = 8192;
    std::size_t finePatches = 80000;  ///< at most, of the mesh that stands for the light itself
    double fineThreshold = 1e-6;      ///< of the links that this mesh is solved by
    std::size_t repeats = 3;
    double limit = 20.0;  ///< seconds: settings that are expected to take longer are left out

    /// Whether the whole error is measured at so many patches: where the fine mesh can be finer.
    bool measuresWhole(std::size_t count) const { return 4 * count <= finePatches; }
};

StudyPlan fullPlan();
/// A minute for four scenes.
StudyPlan quickPlan();
/// One number of patches and few levels: seconds.
StudyPlan smallPlan(std::size_t patches);

/// One setting to measure.
struct Step {
    std::size_t patches;
    const StudyMethod* method;
    double level;
    bool usual;  ///< the level at which numbers of patches are compared
};

/// All that a plan measures in a scene: meshes from coarse to fine, methods one after the other, cheap levels first.
///
/// @param methods live as long as the result
std::vector<Step> stepsOf(const StudyPlan& plan, const std::vector<StudyMethod>& methods);

/// The seconds that a setting is expected to take, from smaller ones.
///
/// @param measured  size and seconds, sizes rising
/// @param exponent  with which seconds grow, where fewer than two are known
/// @return 0 where none is known
double expectedSeconds(const std::vector<glm::dvec2>& measured, double size, double exponent);

}  // namespace radlab::study
