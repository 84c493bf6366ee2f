#pragma once

#include "apps/RenderPicture.h"

namespace radlab {

/// Writes a solved scene as glTF or PLY, by the file's ending, in the colours that the picture has.
///
/// @param radiance the picture, whose exposure the mesh gets
void writeSolution(const std::string& file, const PictureFlags& flags, const SceneInput& input,
                   const RenderSolution& solution, const Image& radiance);

}  // namespace radlab
