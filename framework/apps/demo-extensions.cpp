// Pictures of what the extensions do: rays over the hemisphere, an anti-aliased display, a mirror by a second pass.

#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>

#include <glm/gtc/matrix_transform.hpp>

#include "apps/CommandLine.h"
#include "base/ImageFile.h"
#include "base/ProgressBar.h"
#include "base/WholeFile.h"
#include "course/Extensions.h"
#include "course/PatchMesh.h"
#include "display/FalseColor.h"
#include "display/Label.h"
#include "display/RayMirrorPass.h"
#include "display/RayView.h"
#include "display/ToneMap.h"
#include "scene/X3dReader.h"
#include "solver/Progressive.h"

using radlab::Image;

namespace {

constexpr int edge = 400;  // of a picture, in pixels
constexpr float patchSize = 40.0f, lightSize = 35.0f;
constexpr int raysPerShot = 16384;
const radlab::Limits enough{400, 0.01};

// A scene cut into patches, published, with its rays and its camera.
struct Stage {
    explicit Stage(const std::filesystem::path& file)
        : scene(radlab::readX3d(file)), mesh(scene.vertices, scene.faces, patchSize, lightSize) {
        mesh.publish();
        mesh.reset();
        caster = std::make_unique<RayCaster>(polygons, vertices);
    }

    glm::mat4 camera() const {
        const radlab::Camera from = scene.cameras.empty() ? radlab::Camera() : scene.cameras.front();
        return glm::perspective(from.fieldOfView, 1.0f, 10.0f, 10000.0f) *
               glm::lookAt(from.position, from.position + from.direction, from.up);
    }

    // Shoots with rays until little is left.
    void solve() {
        RandomNumbers random(1);
        radlab::Progressive solver(mesh, [&] { return hemisphereFF(*caster, raysPerShot, random); });
        radlab::ProgressBar bar("shooting", enough.shots, "shots");
        solver.run(enough, [&](const radlab::Progress& progress) {
            bar.show(progress.shots);
            return true;
        });
    }

    radlab::Scene scene;
    radlab::PatchMesh mesh;
    std::unique_ptr<RayCaster> caster;
};

Image shown(const Stage& stage, int samples, float exposure) {
    Image picture(edge, edge);
    antialias(radlab::RayView(*stage.caster, stage.camera(), edge, edge, exposure), samples, picture);
    return picture;
}

// A part of a picture, its pixels enlarged to squares.
Image enlarged(const Image& picture, int left, int top, int factor) {
    Image large(edge, edge);
    for (int y = 0; y < edge; ++y)
        for (int x = 0; x < edge; ++x) large.at(x, y) = picture.at(left + x / factor, top + y / factor);
    return large;
}

Image enlarged(const Image& picture) { return enlarged(picture, edge / 2, edge * 45 / 80, 8); }

radlab::RayMirrorPass firstPass(const Stage& stage) {
    const auto none = [](const MyPolygon*) { return false; };
    return {polygons, vertices, none, stage.camera(), edge, edge};
}

// What the light sends to each patch, per area, as heat colours.
Image formFactorsBy(Stage& stage, int rays) {
    RandomNumbers random(static_cast<std::uint64_t>(rays));
    hemisphereFF(*stage.caster, rays, random);
    for (MyPolygon* patch : polygons) patch->color = Vec3f(patch->formF / patch->area);
    const radlab::RayView view(*stage.caster, stage.camera(), edge, edge, 1.0f);
    Image picture(edge, edge);
    for (int y = 0; y < edge; ++y)
        for (int x = 0; x < edge; ++x)
            picture.at(x, y) = radlab::heatColor(
                std::sqrt(1.5e5f * view.radiance(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f).g));
    return picture;
}

Image noise(const std::filesystem::path& scenes) {
    Stage stage(scenes / "cornell_2.x3d");
    std::vector<Image> pictures;
    std::vector<std::string> titles;
    for (const int rays : {1000, 10000, 100000, 1000000}) {
        pictures.push_back(formFactorsBy(stage, rays));
        titles.push_back(std::to_string(rays) + " RAYS");
    }
    return radlab::contactSheet(pictures, titles, 2);
}

Image edges(const std::filesystem::path& scenes) {
    Stage stage(scenes / "cornell_2.x3d");
    stage.solve();
    const float exposure = radlab::autoExposure(firstPass(stage).first());
    const Image jagged = shown(stage, 1, exposure), smooth = shown(stage, 4, exposure);
    return radlab::contactSheet({jagged, smooth, enlarged(jagged), enlarged(smooth)},
                                {"1 SAMPLE A PIXEL", "4 X 4 SAMPLES", "ENLARGED", "ENLARGED"}, 2);
}

// Adds what one face shows as a mirror.
void addFace(const Stage& stage, int face, Image& picture) {
    const radlab::Face& of = stage.scene.faces[static_cast<std::size_t>(face)];
    const MyPolygon* first = nullptr;
    const auto isMirror = [&](const MyPolygon* patch) {
        return stage.mesh.faceOf[static_cast<std::size_t>(patch - stage.mesh.patches.data())] == face;
    };
    for (const MyPolygon* patch : polygons)
        if (!first && isMirror(patch)) first = patch;
    const radlab::RayMirrorPass pass(polygons, vertices, isMirror, stage.camera(), edge, edge);
    mirrorScene(pass, first->center, first->normal, of.material->specular, picture);
}

Image mirror(const std::filesystem::path& scenes) {
    Stage stage(scenes / "mirror.x3d");
    stage.solve();
    const Image first = firstPass(stage).first();
    Image both = first;
    for (std::size_t face = 0; face < stage.scene.faces.size(); ++face)
        if (stage.scene.faces[face].material->specular.r > 0.0f) addFace(stage, static_cast<int>(face), both);
    const float exposure = radlab::autoExposure(first);
    return radlab::contactSheet({radlab::toneMap(first, exposure), radlab::toneMap(both, exposure)},
                                {"FIRST PASS", "WITH THE SECOND"}, 2);
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App flags(
        "Draws what the extensions do: rays over the hemisphere, an anti-aliased display, a mirror by a second pass.");
    std::string out = "out/demo-extensions";
    std::string scenes = RADLAB_SOURCE_DIR "/resources/scenes";
    flags.add_option("--out", out, "Folder to write to, made where it does not exist")->capture_default_str();
    flags.footer("Example: ./radlab demo --extensions --out /tmp/demo");
    return radlab::runCommandLine(flags, argc, argv, [&] {
        radlab::makeFolder(out);
        const std::pair<const char*, Image (*)(const std::filesystem::path&)> pictures[] = {
            {"hemisphere.png", noise}, {"antialiasing.png", edges}, {"mirror.png", mirror}};
        for (const auto& [name, draw] : pictures) {
            const std::filesystem::path file = std::filesystem::path(out) / name;
            radlab::writeImage(file, draw(scenes));
            std::cout << "made " << file.string() << std::endl;
        }
        return 0;
    });
}
