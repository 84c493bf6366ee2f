#pragma once

#include <filesystem>

namespace radlab {

/// Draws the handout's pictures of single steps: coarse meshes, shadings, hemicubes of several sizes, and a profile across a wall.
///
/// @pre  a GlContext is current
/// @cost some seconds
void drawHandoutPictures(const std::filesystem::path& folder);

}  // namespace radlab
