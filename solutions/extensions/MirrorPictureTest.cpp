// The mirror of the second pass beside the mirror that the engine follows ray by ray.
#ifdef RADLAB_HAVE_ENGINE

#include <numbers>

#include <doctest/doctest.h>
#include <glm/gtc/matrix_transform.hpp>

#include "course/Extensions.h"
#include "course/PatchMesh.h"
#include "display/RayMirrorPass.h"
#include "engine/Picture.h"
#include "scene/X3dReader.h"

using namespace radlab;

namespace {

constexpr int edge = 120;

// The scene with the mirror, its matt patches shining as their centres lie.
struct Mirrored {
    Scene scene = readX3d(RADLAB_SOURCE_DIR "/resources/scenes/mirror.x3d");
    PatchMesh mesh{scene.vertices, scene.faces, 60.0f, 60.0f};
    glm::mat4 camera;

    Mirrored() {
        mesh.publish();
        for (std::size_t i = 0; i < mesh.patches.size(); ++i) {
            MyPolygon& patch = mesh.patches[i];
            patch.color = isMirror(mesh.faceOf[i]) ? Vec3f(0.0f) : 0.1f + glm::abs(patch.center) / 600.0f;
        }
        const Camera& from = scene.cameras.front();
        camera = glm::perspective(from.fieldOfView, 1.0f, 10.0f, 10000.0f) *
                 glm::lookAt(from.position, from.position + from.direction, from.up);
    }

    bool isMirror(int face) const { return scene.faces[static_cast<std::size_t>(face)].material->specular.r > 0.0f; }

    int faceOf(const MyPolygon* patch) const {
        return mesh.faceOf[static_cast<std::size_t>(patch - mesh.patches.data())];
    }

    RayMirrorPass passOf(const RayMirrorPass::IsMirror& which) const {
        return {polygons, vertices, which, camera, edge, edge};
    }

    Image byEngine() const {
        const engine::Geometry geometry = engine::geometryOf(scene, mesh);
        std::vector<engine::Point> radiosity;
        for (const MyPolygon& patch : mesh.patches) radiosity.push_back(engine::Point(patch.color) * std::numbers::pi);
        engine::Frame frame;
        frame.camera = scene.cameras.front();
        frame.width = frame.height = edge;
        engine::PictureOptions options;
        options.antialiasing = engine::Antialiasing::off;
        return drawPicture(engine::TracedScene(geometry, engine::scatteringsOf(scene)), engine::PatchShading(radiosity),
                           frame, options);
    }
};

}  // namespace

TEST_CASE(
    "mirror: the second pass shows in each pixel what the engine finds by following rays, but for some at edges") {
    const Mirrored box;
    Image picture = box.passOf([](const MyPolygon*) { return false; }).first();
    for (const MyPolygon& patch : box.mesh.patches) {
        const int face = box.faceOf(&patch);
        if (!box.isMirror(face) || (&patch != box.mesh.patches.data() && box.faceOf(&patch - 1) == face)) continue;
        mirrorScene(box.passOf([&](const MyPolygon* one) { return box.faceOf(one) == face; }), patch.center,
                    patch.normal, box.scene.faces[static_cast<std::size_t>(face)].material->specular, picture);
    }
    const Image expected = box.byEngine();
    const RayMirrorPass mirrors = box.passOf([&](const MyPolygon* patch) { return box.isMirror(box.faceOf(patch)); });
    int inMirror = 0, different = 0, lit = 0;
    for (int y = 0; y < edge; ++y)
        for (int x = 0; x < edge; ++x) {
            if (!mirrors.showsMirror(x, y)) continue;
            ++inMirror;
            lit += expected.at(x, y).g > 0.0f;
            different += glm::length(picture.at(x, y) - expected.at(x, y)) > 1e-3f;
        }
    CHECK(inMirror > 1000);
    CHECK(lit > 300);
    CHECK(different < inMirror / 50);
}

#endif
