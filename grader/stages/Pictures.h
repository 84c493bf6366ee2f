#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/Image.h"
#include "grader/protocol/Message.h"

namespace radlab::grader {

/// A picture of what a submission's numbers say, for a check of the manifest that names reference images.
struct PictureCase {
    std::string check;  ///< id in the manifest
    std::function<std::vector<Step>()> steps;
    std::function<Image(const std::vector<Step>&, const std::vector<StepAnswer>&)> draw;  ///< ready for display
    /// What is wrong beside the picture, in words; empty where nothing is. May be no function.
    std::function<std::string(const std::vector<Step>&, const std::vector<StepAnswer>&)> problem;
};

/// The pictures of all stages, and of all together, of the Cornell box of resources/scenes.
///
///  - max.picture: which patch shoots when, in sixty states that the judge made: yellow first, violet last
///  - ff.picture, hemi.picture: form factors from the light as heat colours
///  - dist.picture: radiance after the light's shot
///  - color.picture: smooth shading of a solved box
///  - ids.picture: the patch IDs in false colours
///  - together.analytic, together.hemicube: the box solved with all functions of the submission
std::vector<PictureCase> pictureCases();

/// The folder of the reference images.
std::string referenceFolder();

/// Where two pictures of one size differ, brighter where they differ more; ready for display.
Image differencePicture(const Image& reference, const Image& found);

}  // namespace radlab::grader
