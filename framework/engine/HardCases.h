#pragma once

#include <string>
#include <vector>

#include "engine/FormFactors.h"

namespace radlab::engine {

/// A pair of patches that is hard for some method, and the form factor that they have.
struct HardCase {
    std::string what;
    Geometry geometry;  ///< F(0→1) is asked for
    double truth = 0.0;
    std::string source;       ///< where the truth comes from
    bool hidden = false;      ///< something stands between them
    bool coincident = false;  ///< two surfaces lie in one place: which of them a ray meets is chance
    bool apart = false;       ///< both are small against their distance, so that points may stand for them
    double exact = 1e-10;     ///< relative error allowed for the exact method
};

/// The table of hard cases.
///
/// @cost nothing worth mention
const std::vector<HardCase>& hardCases();

/// The largest error that a method may make in a case, absolute: infinite where the method is not made for it.
///
/// @param rays of `hemisphere` from the patch, of `visibility` for the pair
double allowedError(const HardCase& hard, Method method, std::size_t rays);

/// What a method makes of a case.
double formFactorOf(const HardCase& hard, Method method, std::size_t rays);

}  // namespace radlab::engine
