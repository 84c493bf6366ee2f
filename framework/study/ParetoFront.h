#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

#include "study/Measurement.h"

namespace radlab::study {

/// The points that no other point beats: none is at most as large in one coordinate and smaller in the other.
///
/// @return their numbers, x rising and y falling; of points that are alike the first
std::vector<std::size_t> paretoFront(const std::vector<glm::dvec2>& points);

/// The rows that no other is both quicker and better than, from the quickest to the best.
std::vector<const Measurement*> bestRows(const std::vector<const Measurement*>& rows, const ErrorKind& error);

/// The quickest row whose error is at most the one asked for; nullptr where none is.
const Measurement* quickestFor(const std::vector<const Measurement*>& rows, const ErrorKind& error, double most);

}  // namespace radlab::study
