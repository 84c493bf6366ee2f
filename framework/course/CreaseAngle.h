#pragma once

#include <vector>

#include "course/DataFormat.h"
#include "course/Face.h"

namespace radlab {

/// Lets faces of a curved surface share vertices, so that nodal averaging smooths over it.
///
/// Two vertices at the same place become one where their faces have the same material and the angle between the faces'
/// normals is at most the crease angle of both. Vertices that are no longer used go.
///
/// @param faceOf for each patch the index of its face
/// @pre   the patches of a face share their vertices, patches of different faces do not
/// @cost  linear in the number of vertices of faces with a crease angle
/// @source [X3D, section 11.2.3] crease angle
void shareWithinCreaseAngle(const std::vector<Face>& faces, const std::vector<int>& faceOf,
                            std::vector<MyVertex>& vertices, std::vector<MyPolygon>& patches);

}  // namespace radlab
