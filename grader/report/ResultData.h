#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <kainjow/mustache.hpp>

#include "grader/protocol/Result.h"

namespace radlab::grader {

/// An image as a page shows it.
struct ShownImage {
    std::string address;  ///< of a file beside the page, or data: with the image itself
    std::string title;    ///< "reference", "yours" or "difference"
    int width = 0, height = 0;
};

/// The images of a check, side by side.
struct ShownPicture {
    std::string caption;
    double rms = 0.0, tolerance = 0.0;  ///< as in Picture
    std::vector<ShownImage> images;
};

/// The picture of a check, if it has one.
using PictureOf = std::function<std::optional<ShownPicture>(const StageResult&, const CheckResult&)>;

/// Gives the template report.mustache all that it says about a result: verdict, marks, compiler, stages and checks.
void setResult(kainjow::mustache::data& values, const Result& result, const PictureOf& pictureOf);

}  // namespace radlab::grader
