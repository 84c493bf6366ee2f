#pragma once

#include <string>

#include "scene/Scene.h"

namespace radlab {

/// Which effects a scene calls for.
struct Effects {
    bool occlusion = false;  ///< some face may hide a part of another one
    std::string reason;      ///< one line for the user, naming the face that decides
};

/// Finds out which effects a scene calls for, so that the others need not be simulated.
///
/// Nothing is ever hidden where every corner of every face lies on or above the plane of every face, as in a
/// room with no furniture seen from inside: a straight line between two points of such a scene never passes
/// through a face. A two-sided face hides nothing where all corners lie on one side of it, whichever that is.
///
/// @return occlusion is true wherever this cannot be shown, so that it is never wrongly left out, up to a
///         tolerance of 1e-5 of the scene's diagonal
/// @cost   one pass over blocks of 64 corners for each plane that faces lie in, until the first that may hide
///         something; gives up, with occlusion true, after about a second
Effects findEffects(const Scene& scene);

}  // namespace radlab
