#include "viewer/ViewerFiles.h"

#include <cstdint>
#include <cstdio>

#include "scene/X3dReader.h"
#include "viewer/Simulation.h"

namespace radlab {

namespace {

constexpr double patchesAtFirst = 1000.0;

}  // namespace

OpenedScene openedScene(std::filesystem::path file) {
    OpenedScene input;
    if (file.extension() == ".xml") {
        const Resource resource = readResource(file);
        input.state.patchSize = resource.patchSize;
        input.state.lightSize = resource.lightSize;
        input.state.hemicubeSize = resource.hemicubeSize;
        input.state.method = resource.method;
        file = resource.sceneFile;
    }
    input.scene = readX3d(file);
    if (!(input.state.patchSize > 0.0f))
        input.state.patchSize = input.state.lightSize = patchSizeFor(input.scene, patchesAtFirst);
    const Camera camera = input.scene.cameras.empty() ? Camera{} : input.scene.cameras.front();
    input.state.camera = orbitFrom(camera, input.scene.vertices);
    if (input.scene.cameras.empty()) {
        const Ball ball = ballRound(input.scene.vertices);
        input.state.camera.frame(ball.centre, ball.radius);
    }
    return input;
}

std::filesystem::path keptFile(const std::filesystem::path& folder, const std::filesystem::path& scene) {
    std::uint64_t hash = 14695981039346656037u;  // FNV-1a, of the path, since scenes of one name lie in many folders
    for (const char c : std::filesystem::absolute(scene).lexically_normal().string())
        hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
    char name[32];
    std::snprintf(name, sizeof name, "-%08x.json", static_cast<unsigned>(hash >> 32 ^ hash));
    return folder / (scene.stem().string() + name);
}

std::filesystem::path nextScreenshot(const std::filesystem::path& folder, const std::string& name) {
    for (int number = 1;; ++number) {
        char ending[32];
        std::snprintf(ending, sizeof ending, "-%03d.png", number);
        if (!std::filesystem::exists(folder / (name + ending))) return folder / (name + ending);
    }
}

}  // namespace radlab
