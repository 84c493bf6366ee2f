#include "study/StudyPictures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "display/FalseColor.h"
#include "display/ToneMap.h"
#include "engine/Picture.h"

namespace radlab::study {

using namespace engine;

namespace {

constexpr int pixels = 360;

Image drawn(const StudyMesh& mesh, const PatchShading& shading) {
    Frame frame;
    frame.width = frame.height = pixels;
    frame.background = Point(mesh.scene.background);
    if (!mesh.scene.cameras.empty()) frame.camera = mesh.scene.cameras.front();
    return drawPicture(mesh.traced(), shading, frame);
}

Point colorOf(const Point& found, const Point& truth) {
    const double right = glm::length(truth), off = glm::length(found - truth);
    if (!(right > 0.0)) return Point(0.0);
    const double share = std::log(off / right / leastShown) / std::log(mostShown / leastShown);
    return Point(heatColor(static_cast<float>(std::clamp(share, 0.0, 1.0))));
}

}  // namespace

Image solvedPicture(const StudyMesh& mesh, const std::vector<Point>& radiosity) {
    const Image radiance = drawn(mesh, PatchShading(mesh.mesh, mesh.geometry, radiosity));
    return toneMap(radiance, autoExposure(radiance));
}

Image errorMap(const StudyMesh& mesh, const std::vector<Point>& found, const std::vector<Point>& truth) {
    std::vector<Point> colors(truth.size());
    for (std::size_t i = 0; i < truth.size(); ++i)
        colors[i] = std::numbers::pi * colorOf(found[i], truth[i]);  // pictures show radiosity over π
    return drawn(mesh, PatchShading(std::move(colors)));
}

}  // namespace radlab::study
