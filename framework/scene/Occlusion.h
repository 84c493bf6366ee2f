#pragma once

#include <string>

#include "scene/Scene.h"

namespace radlab {

/// Whether faces of a scene may hide parts of each other.
struct Occlusion {
    bool found = false;
    std::string reason;  ///< one line for the user, naming the face that decides
};

/// Finds out whether anything may be hidden, so that it need not be looked for.
///
/// Nothing is ever hidden where every corner of every face lies on or above the plane of every face, as in a
/// room with no furniture seen from inside: a straight line between two points of such a scene never passes
/// through a face. A two-sided face hides nothing where all corners lie on one side of it, whichever that is.
///
/// @return found is true wherever this cannot be shown, so that it is never wrongly left out, up to a
///         tolerance of 1e-5 of the scene's diagonal
/// @cost   one pass over blocks of 64 corners for each plane that faces lie in, until the first that may hide
///         something; gives up, with found true, after about a second
Occlusion findOcclusion(const Scene& scene);

}  // namespace radlab
