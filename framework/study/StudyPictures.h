#pragma once

#include <vector>

#include "base/Image.h"
#include "study/StudyMesh.h"

namespace radlab::study {

/// The ends of the scale of error maps.
constexpr double leastShown = 1e-4, mostShown = 1.0;

/// A solved mesh as its first camera sees it, ready for display.
Image solvedPicture(const StudyMesh& mesh, const std::vector<engine::Point>& radiosity);

/// The error of every patch in false colours: how far its radiosity is off, as a share of what it should be, on a
/// logarithmic scale from leastShown (black) to mostShown (pale).
Image errorMap(const StudyMesh& mesh, const std::vector<engine::Point>& found, const std::vector<engine::Point>& truth);

}  // namespace radlab::study
