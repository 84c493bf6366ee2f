#pragma once

#include <optional>
#include <string>

#include "grader/protocol/Result.h"
#include "grader/stages/Manifest.h"
#include "grader/stages/Pictures.h"
#include "grader/stages/Verdict.h"

namespace radlab::grader {

/// What the judge makes of a picture.
struct PictureVerdict {
    Status status = Status::pass;
    std::string message;
    std::optional<Picture> picture;  ///< where there is one: with the reference that is nearest to it
};

/// Compares a submission's picture with the references of its line in the manifest.
///
/// Errors: a reference image that is missing, or of another size.
PictureVerdict judgePicture(const ManifestCheck& line, const PictureCase& picture, const std::vector<Step>& steps,
                            const CheckRun& run);

}  // namespace radlab::grader
