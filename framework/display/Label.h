#pragma once

#include <string>

#include "base/Image.h"

namespace radlab {

/// Writes one line of ASCII text into a picture, its top left corner at (x, y); what sticks out is cut off.
///
/// @param scale height of a capital letter is 7 times this many pixels, 1 or more
void writeText(Image& image, int x, int y, const std::string& text, int scale, const glm::vec3& color);

/// Width in pixels of what writeText draws.
int textWidth(const std::string& text, int scale);

/// Pictures in rows of `columns`, each with its title over it, on a dark sheet.
///
/// @pre as many titles as pictures, all pictures of one size
Image contactSheet(const std::vector<Image>& pictures, const std::vector<std::string>& titles, int columns);

}  // namespace radlab
