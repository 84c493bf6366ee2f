#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "grader/protocol/Result.h"

namespace radlab::grader {

/// An image of a check, as the bytes of a PNG file.
struct PngImage {
    std::string title;  ///< "reference", "yours" or "difference"
    std::string png;
    int width = 0, height = 0;  ///< in pixels
};

/// The picture of a check, ready for a page.
struct CheckPicture {
    std::string stage, check;  ///< whose it is: the stage's name and the check's id
    std::string caption;
    double rms = 0.0, tolerance = 0.0;  ///< as in Picture
    std::vector<PngImage> images;
};

/// All that grading a submission gave; the pictures stand beside the result, not in it.
struct Graded {
    Result result;
    std::vector<CheckPicture> pictures;
};

/// As bytes, for storing and for sending from process to process.
std::string toCbor(const Graded& graded);

/// Errors: what toCbor did not write.
Graded gradedFromCbor(std::string_view bytes);

}  // namespace radlab::grader
