#pragma once

#include <functional>
#include <string>
#include <vector>

#include "course/PictureView.h"

namespace radlab::grader {

/// What a program puts into the pixel whose top left corner is (x, y), over what the pixel held.
using PixelRule = std::function<Vec3f(const PictureView& view, float x, float y, int samples, const Vec3f& held)>;

/// The mean radiance at the centres of the samples, ready for display.
Vec3f antialiasedPixel(const PictureView& view, float x, float y, int samples, const Vec3f& held);

/// A misconception of antialias, pixel by pixel.
struct PixelMistake {
    std::string id, text, hint;
    PixelRule rule;
    bool upsideDown = false;  ///< the picture's rows come from the bottom up
};

/// What people do in place of the right thing; special mistakes before general ones.
std::vector<PixelMistake> samplingMistakes();

}  // namespace radlab::grader
