#pragma once

#include <optional>
#include <string>
#include <vector>

#include "grader/protocol/Result.h"

namespace radlab::grader {

/// A factor of a formula, and its value in each sample.
struct Factor {
    std::string name;               ///< "the receiver's area"
    std::vector<double> logs = {};  ///< natural logarithms, one a sample
    double right = 1.0;             ///< the exponent that the formula gives it
    std::string symbol = "";        ///< "r": then powers are written out, "falls as 1/r³, not 1/r²"; may be empty
};

/// Finds which factors of a formula have a wrong exponent, from the ratios of numbers found to numbers expected.
///
/// A least squares fit of log(found/expected) = c + Σ kᶠ log f, with every kᶠ then rounded to halves and c to a product of powers of π and
/// 2; it counts only where what is left over is below 0.1 % in every sample.
/// Factors whose values do not vary, or only together, cannot be told apart and are left out.
///
/// @param logRatios log(found/expected), one a sample
/// @return diagnosis "exponents" that names each wrong factor in words; nothing where the fit fails, or finds no fault
/// @cost   linear in the number of samples
std::optional<Diagnosis> fitExponents(const std::vector<double>& logRatios, const std::vector<Factor>& factors);

}  // namespace radlab::grader
