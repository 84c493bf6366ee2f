#pragma once

#include <vector>

#include "engine/Polygon.h"

namespace radlab::engine {

/// How far radiosities are from better ones of the same patches.
///
/// @param areas of the patches
/// @return RMS of the difference over RMS of the truth, both weighted by area, the channels added up; 0 for a black truth
double relativeError(const std::vector<double>& areas, const std::vector<Point>& found,
                     const std::vector<Point>& truth);

}  // namespace radlab::engine
