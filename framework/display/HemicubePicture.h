#pragma once

#include "base/Image.h"

class Hemicube;

namespace radlab {

/// The read-back buffer of a hemicube, its five faces unfolded, each patch ID in its false colour.
///
/// @pre    readIndexBuffer has been called
/// @return rendersize x rendersize pixels, up on top, ready for display; the unused corners are dark grey
Image hemicubeIds(const Hemicube& hemicube);

/// The delta form factors of a hemicube as heat colours, the same way round.
Image hemicubeWeights(const Hemicube& hemicube);

}  // namespace radlab
