#pragma once

#include <string>

#include "apps/RenderSolution.h"
#include "base/Image.h"
#include "engine/Picture.h"

namespace radlab {

/// How a program was told to draw its picture.
struct PictureFlags {
    std::vector<std::string> files;  ///< pictures, and what else a program writes by the ending
    std::size_t camera = 0;
    int width = 800, height = 800;
    bool flat = false;
    int antialias = 4;
    double exposure = 0.0;  ///< 0: chosen by the picture
};

/// Adds --out, --width, --height, --camera, --exposure, --flat and --antialias to a program's flags.
void addPictureFlags(CLI::App& app, PictureFlags& flags);

/// Errors: the scene has no such camera.
void requireCamera(const PictureFlags& flags, const Scene& scene);

/// A linear picture and how it was made, for the user in a line.
struct RenderPicture {
    Image radiance;
    engine::PictureReport report;  ///< all 0 where paths drew it
    std::string summary;
};

/// The picture of solved radiosities.
RenderPicture drawSolution(const PictureFlags& flags, const SceneInput& input, const RenderSolution& solution);

/// The picture by so many random walks a pixel, with a progress bar.
RenderPicture drawPaths(const PictureFlags& flags, const SceneInput& input, std::size_t samples);

/// How a solution is shaded: smooth where the scene and the flags have it so, with what is still under way.
engine::PatchShading shadingOf(const PictureFlags& flags, const SceneInput& input, const RenderSolution& solution);

/// Display value per radiance: that of the flags, or one that suits the picture.
float exposureOf(const PictureFlags& flags, const Image& radiance);

/// Writes a picture, tone mapped unless its file is one of radiances (.hdr).
void writePicture(const std::string& file, const PictureFlags& flags, const Image& radiance);

}  // namespace radlab
