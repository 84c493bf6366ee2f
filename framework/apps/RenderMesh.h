#pragma once

#include "apps/RenderPicture.h"

namespace radlab {

/// Writes a solved scene as glTF or PLY, by the file's ending, in the colours that the picture has.
///
/// @param exposure display value per radiance
void writeSolution(const std::string& file, const PictureFlags& flags, const SceneInput& input,
                   const RenderSolution& solution, float exposure);

}  // namespace radlab
