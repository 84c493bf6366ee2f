#include "scene/CoincidentFaces.h"

#include <cmath>
#include <filesystem>

#include "scene/SceneTestHelp.h"

using namespace radlab;
using namespace radlab::test;

namespace {

/// Faces, each by its corners.
Scene sceneOf(const std::vector<std::vector<Vec3f>>& outlines) {
    Scene scene;
    for (const std::vector<Vec3f>& outline : outlines) {
        Face face;
        for (const Vec3f& corner : outline) {
            face.corners.push_back(static_cast<int>(scene.vertices.size()));
            scene.vertices.push_back(corner);
        }
        scene.faces.push_back(face);
    }
    return scene;
}

std::size_t countIn(const std::vector<std::vector<Vec3f>>& outlines) {
    const CoincidentFaces found = findCoincidentFaces(sceneOf(outlines));
    CHECK(found.complete);
    return found.count;
}

/// A rectangle that faces up, and turned by an angle about an axis that is none of the coordinates'.
std::vector<Vec3f> tile(float x, float y, float width, float depth, float z = 0.0f, float angle = 0.0f) {
    const glm::dvec3 axis = glm::normalize(glm::dvec3(1, 2, 0.5));
    const double c = std::cos(angle), s = std::sin(angle);
    std::vector<Vec3f> corners;
    for (const glm::dvec3 p : {glm::dvec3(x, y, z), glm::dvec3(x + width, y, z), glm::dvec3(x + width, y + depth, z),
                               glm::dvec3(x, y + depth, z)})
        corners.emplace_back(c * p + s * glm::cross(axis, p) + (1 - c) * glm::dot(axis, p) * axis);
    return corners;
}

std::vector<Vec3f> turned(const std::vector<Vec3f>& corners) { return {corners.rbegin(), corners.rend()}; }

}  // namespace

TEST_CASE("the same face twice is found, whichever corner it starts with and however it lies") {
    for (const float angle : {0.0f, 0.3f, 1.2f}) {
        const std::vector<Vec3f> one = tile(1, 2, 3, 1, 0.5f, angle);
        const std::vector<Vec3f> same = {one[2], one[3], one[0], one[1]};
        CHECK(countIn({one, one}) == 1);
        CHECK(countIn({one, same}) == 1);
        CHECK(countIn({one, one, same}) == 2);
    }
}

TEST_CASE("faces that share part of a plane are found: a lamp in its ceiling, tiles that overlap by a tenth") {
    for (const float angle : {0.0f, 0.3f, 1.2f}) {
        CHECK(countIn({tile(0, 0, 9, 9, 1, angle), tile(4, 4, 1, 1, 1, angle)}) == 1);
        CHECK(countIn({tile(4, 4, 1, 1, 1, angle), tile(0, 0, 9, 9, 1, angle)}) == 1);
        CHECK(countIn({tile(0, 0, 1, 1, 1, angle), tile(0.9f, 0, 1, 1, 1, angle)}) == 1);
    }
}

TEST_CASE("faces that touch along edges or in corners share nothing, T-junctions included, turned and far off") {
    for (const float angle : {0.0f, 0.3f, 1.2f})
        for (const float far : {0.0f, 1000.0f}) {
            CAPTURE(angle);
            CAPTURE(far);
            std::vector<std::vector<Vec3f>> tiles;
            for (int i = 0; i < 12; ++i)
                for (int j = 0; j < 12; ++j) tiles.push_back(tile(far + i * 0.1f, j * 0.1f, 0.1f, 0.1f, 1, angle));
            tiles.push_back(tile(far + 1.2f, 0, 0.5f, 1.2f, 1, angle));
            CHECK(countIn(tiles) == 0);
        }
}

TEST_CASE("back to back, at a small distance, crossing or beside a notch, nothing is shared") {
    const std::vector<Vec3f> one = tile(0, 0, 1, 1);
    CHECK(countIn({one, turned(one)}) == 0);
    CHECK(countIn({one, turned(one), one}) == 1);
    CHECK(countIn({one, tile(0, 0, 1, 1, 1e-4f)}) == 0);
    CHECK(countIn({one, {{0, 0, -1}, {1, 1, -1}, {1, 1, 1}, {0, 0, 1}}}) == 0);
    const std::vector<Vec3f> ell = {{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
    CHECK(countIn({ell, tile(1, 1, 2, 2)}) == 0);
    CHECK(countIn({ell, tile(0.5f, 0.5f, 2, 2)}) == 1);
}

TEST_CASE("faces without area lie upon nothing") {
    const std::vector<Vec3f> line = {{0, 0, 0}, {1, 0, 0}, {0.5f, 0, 0}}, point(3, Vec3f(0.5f, 0.5f, 0));
    CHECK(countIn({tile(0, 0, 1, 1), line, point, line}) == 0);
    CHECK(countIn({}) == 0);
}

TEST_CASE("a reader warns once of faces in one place, with the lines of the first two and their number") {
    const std::string texts = warningsIn(triangle() + "\n" + triangle() + "\n" + triangle()).at(0);
    CHECK(contains(texts, "scene.x3d: faces in the place of an earlier one, facing the same way: 2, "));
    CHECK(contains(texts, "the first is face 1 (line 3), upon face 0 (line 2)"));
}

TEST_CASE("no scene of the project has two faces in one place") {
    for (const auto& entry : std::filesystem::directory_iterator(RADLAB_SOURCE_DIR "/resources/scenes")) {
        if (entry.path().extension() != ".x3d") continue;
        CAPTURE(entry.path().string());
        const WarningCapture capture;
        readX3d(entry.path());
        CHECK(capture.texts.empty());
    }
}

TEST_CASE("a hundred thousand tiles are searched whole, and where all lie in one place the search ends") {
    std::vector<std::vector<Vec3f>> tiles;
    for (int i = 0; i < 320; ++i)
        for (int j = 0; j < 320; ++j)
            tiles.push_back(tile(static_cast<float>(i), static_cast<float>(j), 1, 1, 0, 0.3f));
    CHECK(countIn(tiles) == 0);
    const CoincidentFaces heap = findCoincidentFaces(sceneOf({20'000, tile(0, 0, 1, 1)}));
    CHECK_FALSE(heap.complete);
    CHECK(heap.count > 100);
}
