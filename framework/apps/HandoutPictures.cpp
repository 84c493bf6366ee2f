#include "apps/HandoutPictures.h"

#include <array>
#include <cstdio>
#include <map>

#include "apps/HandoutScene.h"
#include "base/ImageFile.h"
#include "base/WholeFile.h"
#include "course/ProgRef.h"
#include "display/Draw.h"
#include "display/HemicubePicture.h"
#include "display/ToneMap.h"
#include "solver/FormFactors.h"
#include "solver/Progressive.h"

namespace radlab {

namespace {

View viewOf(const HandoutScene& room, int size) {
    View view;
    view.camera = room.scene.cameras.front();
    view.width = view.height = size;
    view.background = room.scene.background;
    return view;
}

void drawMeshes(const std::filesystem::path& folder) {
    for (const auto& [name, size] : {std::pair{"mesh-100.png", 100.0f}, {"mesh-25.png", 25.0f}}) {
        HandoutScene room("cornell_2", size);
        room.mesh.publish();
        writeImage(folder / name, drawWireframe(viewOf(room, 400)));
    }
}

// What would be seen if patches shared their vertices wherever they meet: edges of the room included.
void averageOverCreases() {
    std::map<std::array<float, 3>, std::pair<Vec3f, int>> sums;
    const auto place = [](const MyVertex* v) { return std::array{v->position.x, v->position.y, v->position.z}; };
    for (const MyVertex* vertex : vertices) {
        auto& [color, count] = sums[place(vertex)];
        color += vertex->color * static_cast<float>(vertex->colorcount);
        count += vertex->colorcount;
    }
    for (MyVertex* vertex : vertices) {
        const auto& [color, count] = sums[place(vertex)];
        vertex->color = color / static_cast<float>(count);
    }
}

// The radiance along a row of pixels of the back wall, flat and smooth.
void writeProfile(const std::filesystem::path& file, const Image& flat, const Image& smooth) {
    const int y = flat.height() / 2;
    std::string table;
    for (int x = flat.width() * 3 / 10; x < flat.width() * 7 / 10; ++x) {
        char line[80];
        std::snprintf(line, sizeof line, "%d %.6g %.6g\n", x, static_cast<double>(flat.at(x, y).g),
                      static_cast<double>(smooth.at(x, y).g));
        table += line;
    }
    writeFile(file, table);
}

void drawShadings(const std::filesystem::path& folder) {
    HandoutScene room("cornell_1", 80.0f);
    Progressive solver(room.mesh, formFactorsBy(FormFactorMethod::analytic, 256));
    solver.run({20000, 0.01});
    const View view = viewOf(room, 400);
    const Image flat = drawRadiance(view, Shading::flat), smooth = drawRadiance(view, Shading::smooth);
    const float exposure = autoExposure(flat);
    writeImage(folder / "flat.png", toneMap(flat, exposure));
    writeImage(folder / "smooth.png", toneMap(smooth, exposure));
    writeProfile(folder / "profile.dat", flat, smooth);
    averageOverCreases();
    writeImage(folder / "creases.png", toneMap(drawRadiance(view, Shading::smooth), exposure));
}

// Each pixel as a square of pixels.
Image enlarged(const Image& image, int factor) {
    Image large(image.width() * factor, image.height() * factor);
    for (int y = 0; y < large.height(); ++y)
        for (int x = 0; x < large.width(); ++x) large.at(x, y) = image.at(x / factor, y / factor);
    return large;
}

void drawHemicubes(const std::filesystem::path& folder) {
    HandoutScene room("cornell_2", 40.0f);
    room.mesh.publish();
    for (const int size : {16, 64, 192}) {
        Hemicube hemicube(size);
        calcFF(&hemicube);
        writeImage(folder / ("hemicube-" + std::to_string(size) + ".png"), enlarged(hemicubeIds(hemicube), 192 / size));
    }
    writeImage(folder / "hemicube-weights.png", hemicubeWeights(Hemicube(192)));
}

}  // namespace

void drawHandoutPictures(const std::filesystem::path& folder) {
    drawMeshes(folder);
    drawShadings(folder);
    drawHemicubes(folder);
}

}  // namespace radlab
