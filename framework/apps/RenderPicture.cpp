#include "apps/RenderPicture.h"

#include <filesystem>

#include <CLI/CLI.hpp>

#include "base/ImageFile.h"
#include "base/ProgressBar.h"
#include "base/Stopwatch.h"
#include "display/ToneMap.h"
#include "engine/PathTracer.h"
#include "engine/Picture.h"
#include "engine/Shooting.h"

namespace radlab {

using namespace engine;

namespace {

Frame frameOf(const PictureFlags& flags, const Scene& scene) {
    Frame frame;
    frame.width = flags.width;
    frame.height = flags.height;
    frame.background = Point(scene.background);
    if (flags.camera < scene.cameras.size()) frame.camera = scene.cameras[flags.camera];
    return frame;
}

}  // namespace

void addPictureFlags(CLI::App& app, PictureFlags& flags) {
    app.add_option("-o,--out", flags.files,
                   "What to write, by its ending: .png, .hdr with linear radiance; or the solved mesh: .glb or .gltf "
                   "(glTF 2.0), .ply; repeatable")
        ->allow_extra_args(false);
    app.add_option("--width", flags.width, "Pixels")->capture_default_str()->check(CLI::Range(1, 8192));
    app.add_option("--height", flags.height, "Pixels")->capture_default_str()->check(CLI::Range(1, 8192));
    app.add_option("--camera", flags.camera, "Which of the scene's viewpoints, the first is 0")->capture_default_str();
    app.add_option("--exposure", flags.exposure,
                   "Display value per radiance, of a PNG or a mesh; else chosen by the picture")
        ->check(CLI::PositiveNumber);
    app.add_flag("--flat", flags.flat, "One colour a patch, not smooth from vertex to vertex");
    app.add_option("--antialias", flags.antialias, "Samples along each edge of a pixel that shows an edge; 1: off")
        ->capture_default_str()
        ->check(CLI::Range(1, 32));
}

void requireCamera(const PictureFlags& flags, const Scene& scene) {
    if (flags.camera > 0 && flags.camera >= scene.cameras.size())
        throw Error(scene.file + ": found " + std::to_string(scene.cameras.size()) + " viewpoints, and --camera " +
                    std::to_string(flags.camera) + " (the first is 0)");
}

PatchShading shadingOf(const PictureFlags& flags, const SceneInput& input, const RenderSolution& solution) {
    std::vector<Point> radiosity = solution.radiosity;
    addAmbient(radiosity, solution.surfaces, solution.ambient);
    return flags.flat || !input.effects.has(Effect::smooth) ? PatchShading(radiosity)
                                                            : PatchShading(*input.mesh, input.geometry, radiosity);
}

RenderPicture drawSolution(const PictureFlags& flags, const SceneInput& input, const RenderSolution& solution) {
    const TracedScene scene(input.geometry, input.scatterings);
    const PatchShading shading = shadingOf(flags, input, solution);
    PictureOptions options;
    options.samplesPerEdge = input.effects.has(Effect::antialias) ? flags.antialias : 1;
    const std::size_t times = options.samplesPerEdge > 1 ? 2 : 1;
    ProgressBar bar("picture", static_cast<double>(times * tilesOf(flags.width, flags.height)), "tiles");
    options.progress = [&](std::size_t tiles) { bar.show(static_cast<double>(tiles)); };
    RenderPicture picture;
    PictureReport& report = picture.report;
    picture.radiance = drawPicture(scene, shading, frameOf(flags, input.scene), options, &report);
    char text[300];
    std::snprintf(text, sizeof text,
                  "picture: %zu rays, %zu gathers, %zu of %zu pixels sampled more than once, %.3g s%s", report.rays,
                  report.gathers, report.sampledMore, picture.radiance.data().size(), report.seconds,
                  report.stopped ? "\nstopped by Ctrl-C: other pixels should have been, too" : "");
    picture.summary = text;
    return picture;
}

RenderPicture drawPaths(const PictureFlags& flags, const SceneInput& input, std::size_t samples) {
    const Stopwatch watch;
    const TracedScene scene(input.geometry, input.scatterings);
    const Frame frame = frameOf(flags, input.scene);
    ProgressBar bar("path tracing", static_cast<double>(samples) * frame.width * frame.height, "paths");
    std::size_t fewest = 0;
    RenderPicture picture;
    picture.radiance = pathTracePicture(
        scene, frame, samples, [&](std::size_t paths) { bar.show(static_cast<double>(paths)); }, &fewest);
    char text[200];
    std::snprintf(text, sizeof text, "picture: path tracing, %zu paths a pixel, %zu rays, %.3g s%s", fewest,
                  scene.rays(), watch.seconds(), fewerText(fewest, samples).c_str());
    picture.summary = text;
    return picture;
}

float exposureOf(const PictureFlags& flags, const Image& radiance) {
    return flags.exposure > 0.0 ? static_cast<float>(flags.exposure) : autoExposure(radiance);
}

void writePicture(const std::string& file, const PictureFlags& flags, const Image& radiance) {
    if (std::filesystem::path(file).extension() == ".hdr") return writeImage(file, radiance);
    writeImage(file, toneMap(radiance, exposureOf(flags, radiance)));
}

}  // namespace radlab
