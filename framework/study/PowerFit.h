#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>

namespace radlab::study {

/// y = factor·x^exponent
struct PowerFit {
    double factor = 0.0, exponent = 0.0;

    double at(double x) const;
};

/// The power of x that fits best: least squares of the logarithms.
///
/// @return nothing where fewer than two different x above 0 have a y above 0
std::optional<PowerFit> fitPower(const std::vector<glm::dvec2>& points);

}  // namespace radlab::study
