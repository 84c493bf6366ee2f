#pragma once

#include <cstddef>
#include <string>

#include "scene/Scene.h"

namespace radlab {

/// Faces of a scene that lie, wholly or in part, in the place of an earlier one and face the same way.
struct CoincidentFaces {
    std::size_t count = 0;               ///< those that lie upon an earlier one
    std::size_t earlier = 0, later = 0;  ///< the first pair, by the later face; indices
    bool complete = true;                ///< false: the search was given up, there may be more
};

/// Looks for faces that share a part of a plane and of its front: which of them is seen there is chance.
///
/// Faces that touch along edges share nothing, neither do faces back to back, as two sides of a sheet. One place is what float
/// coordinates cannot tell apart, and a share is more than a thousandth of the smaller face.
///
/// @return the same for every run
/// @cost   n log n where boxes around the faces overlap for few pairs; given up after some seconds where they do for most
CoincidentFaces findCoincidentFaces(const Scene& scene);

/// The faces in a line of words, with file and line of the first pair; empty where there are none.
std::string describe(const CoincidentFaces& found, const Scene& scene);

}  // namespace radlab
