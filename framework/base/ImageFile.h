#pragma once

#include <filesystem>
#include <string>

#include "base/Image.h"

namespace radlab {

/// Whether a file's ending is that of a picture: .png or .hdr.
bool isImageFile(const std::filesystem::path& file);

/// Writes a picture as PNG (8 bits a channel) or Radiance HDR, by the ending of the file's name.
///
/// PNG takes the numbers as they are: 0 to 1 is black to white, ready for display, the rest is clamped. HDR keeps
/// linear values of 0 and more with a shared exponent (1 %). In both a pixel that is not finite becomes magenta so
/// that it is seen.
/// The file appears whole or not at all.
/// Errors: an unknown ending, a folder that does not exist, a full disk.
void writeImage(const std::filesystem::path& file, const Image& image);

/// The pixels as PNG keeps them: red, green and blue with 8 bits each, row by row from the top.
std::string rgbBytes(const Image& image);

/// A picture as the bytes of a PNG file.
///
/// @pre    it is not empty
/// Errors: a build without stb.
std::string pngBytes(const Image& image);

/// Reads a PNG (0 to 1 a channel, as stored) or Radiance HDR (linear).
///
/// Errors: no such file, an unknown ending, contents that are cut off or of another kind.
Image readImage(const std::filesystem::path& file);

}  // namespace radlab
