#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/Radiosity.h"
#include "study/StudyMesh.h"

namespace radlab::study {

/// What a method found.
struct Outcome {
    std::vector<engine::Point> radiosity;  ///< W/m² per channel, of every patch
    std::size_t shots = 0;                 ///< 0 for methods that do not shoot
};

/// Finds the radiosities of a mesh; everything that the method needs beyond the mesh is made and dropped inside.
using Solve = std::function<Outcome(StudyMesh& mesh)>;

/// A level that means: all that there is to do.
constexpr double everything = 1e300;

/// Exponents with which seconds are taken to grow, until two are measured.
struct Growth {
    double overLevels, overPatches;
};

/// A way to radiosities, at any level of its setting.
struct StudyMethod {
    std::string name;
    std::string unit;                 ///< what a level counts, for people: "rays"; empty where there is one level alone
    std::vector<double> full, quick;  ///< levels, the cheapest first
    double usual = 0.0;               ///< the level at which methods are compared over numbers of patches; 0: not
    Growth growth;
    std::function<Outcome(StudyMesh& mesh, double level)> solve;
    /// Of the light itself, where that is not what `solve` finds: not one radiosity a patch on the way. Else empty.
    std::function<Outcome(StudyMesh& mesh, double level)> solveWhole = {};
    bool usesOpenGl = false;
};

/// The methods that are compared: exact form factors where nothing hides anything, else exact ones times visibility.
///
/// Point to point, point to polygon and the course's formula see nothing hidden; they are there to show what that costs.
///
/// @param occlusion whether anything may hide anything
std::vector<StudyMethod> studyMethods(bool occlusion);

/// "256 rays", "threshold 1e-4", "all shots"; empty for a method of one level.
std::string settingName(const StudyMethod& method, double level);

}  // namespace radlab::study
