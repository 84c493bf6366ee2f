#include "apps/SceneInput.h"

#include <cmath>
#include <filesystem>

#include <CLI/CLI.hpp>

#include "base/Memory.h"
#include "base/ProgressBar.h"
#include "scene/ResourceFile.h"
#include "scene/X3dReader.h"

namespace radlab {

namespace {

constexpr double bytesOfPatch = 700.0;  // in the mesh and in the geometry

struct Sizes {
    double patch = 0.0, light = 0.0;
};

// The scene, and the sizes of patches that flags or settings ask for.
Scene read(const SceneFlags& flags, Sizes& sizes) {
    std::filesystem::path file = flags.file;
    if (file.extension() == ".xml") {
        const Resource settings = readResource(file);
        file = settings.sceneFile;
        sizes = {static_cast<double>(settings.patchSize), static_cast<double>(settings.lightSize)};
    }
    if (flags.patchSize > 0.0) sizes = {flags.patchSize, flags.patchSize};
    return shownAs("reading " + file.filename().string(), [&] { return readX3d(file); });
}

std::vector<Force> forcesOf(const SceneFlags& flags) {
    std::vector<Force> forces;
    for (const std::string& text : flags.force) forces.push_back(forceNamed(text));
    return forces;
}

void decide(SceneInput& input, const std::vector<Force>& forces) {
    input.effects = findEffects(input.scene, input.mesh.get());
    for (const Force& force : forces) apply(force, input.effects);
    input.scatterings = engine::scatteringsOf(input.scene, input.effects);
    input.geometry.through = engine::throughOf(input.scatterings);
}

}  // namespace

void addSceneFlags(CLI::App& app, SceneFlags& flags) {
    app.add_option("SCENE", flags.file, "An X3D file, or settings (Resource.xml) that name one")->required();
    app.add_option("--patch-size", flags.patchSize,
                   "Longest edge of a patch; else as the settings say, or for about 1000 patches")
        ->check(CLI::PositiveNumber);
    app.add_option("--force", flags.force, "EFFECT=on or EFFECT=off, against what the scene calls for; repeatable")
        ->allow_extra_args(false);
}

SceneInput readSceneInput(const SceneFlags& flags) {
    const std::vector<Force> forces = forcesOf(flags);
    SceneInput input;
    Sizes sizes;
    input.scene = read(flags, sizes);
    if (sizes.patch == 0.0) sizes.patch = sizes.light = engine::patchSizeFor(input.scene, flags.patches);
    const double expected = engine::patchesAt(input.scene, sizes.patch, sizes.light);
    requireMemory(bytesOfPatch * expected, "about " + std::to_string(std::llround(expected)) + " patches",
                  "take larger patches");
    shownAs("cutting patches", [&] {
        input.mesh = std::make_unique<PatchMesh>(input.scene.vertices, input.scene.faces,
                                                 static_cast<float>(sizes.patch), static_cast<float>(sizes.light));
        input.geometry = engine::geometryOf(input.scene, *input.mesh);
    });
    shownAs("looking for effects", [&] { decide(input, forces); });
    char text[64];
    std::snprintf(text, sizeof text, ": %zu patches of size %.4g", input.geometry.patches.size(), sizes.patch);
    input.summary = input.scene.file + text;
    return input;
}

SceneInput readFacesInput(const SceneFlags& flags) {
    const std::vector<Force> forces = forcesOf(flags);
    SceneInput input;
    Sizes sizes;
    input.scene = read(flags, sizes);
    input.geometry = engine::geometryOf(input.scene);
    decide(input, forces);
    input.summary = input.scene.file + ": its " + std::to_string(input.geometry.patches.size()) + " faces as patches";
    return input;
}

}  // namespace radlab
