#pragma once

#include <vector>

#include "course/DataFormat.h"

namespace radlab::grader {

/// What a submission's function works on: patches and the vertices that they share.
struct State {
    std::vector<MyPolygon> patches;
    std::vector<MyVertex> corners;  ///< MyPolygon::vertex are indices into these
};

}  // namespace radlab::grader
