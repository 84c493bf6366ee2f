#include "course/Mesher.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <doctest/doctest.h>

#include "base/Warning.h"
#include "course/TestMeshes.h"

using namespace radlab;
using namespace radlab::test;
using doctest::Approx;

namespace {

float totalArea(const PatchMesh& mesh) {
    double sum = 0.0;
    for (const MyPolygon& patch : mesh.patches) sum += patch.area;
    return static_cast<float>(sum);
}

std::size_t unusedVertices(const PatchMesh& mesh) {
    std::set<int> used;
    for (const MyPolygon& patch : mesh.patches) used.insert(patch.vertex, patch.vertex + patch.vertices);
    return mesh.corners.size() - used.size();
}

PatchMesh meshOf(const std::vector<Vec3f>& corners, float size) {
    Faces faces;
    faces.add(corners);
    return PatchMesh(faces.positions, faces.faces, size, size);
}

std::string errorOf(const std::vector<Vec3f>& corners, float size = 1.0f) {
    try {
        meshOf(corners, size);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

const std::vector<Vec3f> ell = {{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};

}  // namespace

TEST_CASE("a quadrilateral becomes round(edge / size) cells along each edge") {
    const PatchMesh mesh = meshOf({{0, 0, 0}, {2.4f, 0, 0}, {2.4f, 1.6f, 0}, {0, 1.6f, 0}}, 1.0f);
    CHECK(mesh.patches.size() == 2 * 2);
    CHECK(mesh.corners.size() == 3 * 3);
    for (const MyPolygon& patch : mesh.patches) {
        CHECK(patch.vertices == 4);
        CHECK(patch.area == Approx(1.2 * 0.8));
        CHECK(patch.normal == Vec3f(0, 0, 1));
    }
    CHECK(mesh.patches[0].center.x == Approx(0.6));
    CHECK(mesh.patches[0].center.y == Approx(0.4));
}

TEST_CASE("a face smaller than the size stays one patch") {
    CHECK(meshOf(square(0, true), 100.0f).patches.size() == 1);
    CHECK(meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 100.0f).patches.size() == 1);
}

TEST_CASE("a triangle becomes n squared triangles that tile it") {
    const PatchMesh mesh = meshOf({{0, 0, 0}, {4, 0, 0}, {0, 3, 0}}, 1.0f);
    CHECK(mesh.patches.size() == 25);  // round(5 / 1) squared
    CHECK(mesh.corners.size() == 6 * 7 / 2);
    for (const MyPolygon& patch : mesh.patches) {
        CHECK(patch.vertices == 3);
        CHECK(patch.area == Approx(6.0 / 25.0));
        CHECK(patch.normal == Vec3f(0, 0, 1));
    }
}

TEST_CASE("a larger polygon is cut to cells, concave or not, and loses no area") {
    const std::vector<Vec3f> hexagon = {{2, 0, 0},  {1, 1.7f, 0},   {-1, 1.7f, 0},
                                        {-2, 0, 0}, {-1, -1.7f, 0}, {1, -1.7f, 0}};
    const std::vector<Vec3f> arrow = {{0, 0, 0}, {2, -1, 0}, {1, 0, 0}, {2, 1, 0}};
    for (const auto& [corners, area] : {std::pair{hexagon, 10.2}, std::pair{ell, 5.0}, std::pair{arrow, 1.0}}) {
        for (const float size : {0.09f, 0.5f, 1.0f, 10.0f}) {
            CAPTURE(size);
            const PatchMesh mesh = meshOf(corners, size);
            CHECK(totalArea(mesh) == Approx(area).epsilon(1e-5));
            CHECK(unusedVertices(mesh) == 0);
            for (const MyPolygon& patch : mesh.patches) {
                CHECK(patch.normal == Vec3f(0, 0, 1));
                CHECK(patch.area <= size * size * 2.3f);
                CHECK(patch.area > 0.0f);
            }
        }
    }
}

TEST_CASE("an L of whole cells becomes exactly those cells") {
    const PatchMesh mesh = meshOf(ell, 1.0f);
    CHECK(mesh.patches.size() == 5);
    for (const MyPolygon& patch : mesh.patches) CHECK(patch.vertices == 4);
    CHECK(mesh.corners.size() == 12);
}

TEST_CASE("centres are centroids of area, not means of corners") {
    const PatchMesh mesh =
        meshOf({{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 1, 0}}, 100.0f);  // 1 x 1 square and a 3 x 1 triangle
    CHECK(mesh.patches[0].area == Approx(2.5));
    CHECK(mesh.patches[0].center.x == Approx((1.0 * 0.5 + 1.5 * 2.0) / 2.5));
    CHECK(mesh.patches[0].center.y == Approx((1.0 * 0.5 + 1.5 / 3.0) / 2.5));
}

TEST_CASE("vertices are shared inside a face and never with another face") {
    Faces room;
    room.addRoom(Vec3f(0), Vec3f(1), material(Vec3f(0.5f)));
    const auto mesh = room.mesh(0.25f);
    CHECK(mesh->patches.size() == 6 * 16);
    CHECK(mesh->corners.size() == 6 * 25);
    std::vector<std::set<int>> facesOf(mesh->corners.size());
    for (std::size_t i = 0; i < mesh->patches.size(); ++i)
        for (int k = 0; k < mesh->patches[i].vertices; ++k) facesOf[mesh->patches[i].vertex[k]].insert(mesh->faceOf[i]);
    for (const std::set<int>& faces : facesOf) CHECK(faces.size() == 1);
}

TEST_CASE("faces of a curved surface share vertices where they meet at less than their crease angle") {
    const auto roof = [](float creaseAngle, const std::shared_ptr<const Material>& right) {
        Faces faces;  // two sides of a roof that meet at 90 degrees
        faces.add({{0, 0, 0}, {1, 0, 1}, {1, 2, 1}, {0, 2, 0}}, right);
        faces.add({{1, 0, 1}, {2, 0, 0}, {2, 2, 0}, {1, 2, 1}}, faces.faces[0].material);
        for (Face& face : faces.faces) face.creaseAngle = creaseAngle;
        return faces;
    };
    const auto white = material(Vec3f(0.5f));
    CHECK(roof(0.0f, white).mesh(1.0f)->corners.size() == 2 * 6);
    CHECK(roof(1.5f, white).mesh(1.0f)->corners.size() == 2 * 6);
    const auto smooth = roof(1.6f, white).mesh(1.0f);
    CHECK(smooth->corners.size() == 2 * 6 - 3);
    for (const MyPolygon& patch : smooth->patches) {
        Vec3f centre(0.0f);
        for (const int corner : patch.vertex) centre += 0.25f * smooth->corners.at(corner).position;
        CHECK(glm::distance(centre, patch.center) < 1e-6f);
    }
    Faces two = roof(1.6f, white);
    two.faces[1].material = material(Vec3f(0.7f));
    CHECK(two.mesh(1.0f)->corners.size() == 2 * 6);
}

TEST_CASE("patches begin with their emission unshot, their reflectance as colour and no form factor") {
    Faces faces;
    faces.add(square(0, true), material(Vec3f(0.1f, 0.2f, 0.3f), Vec3f(4, 5, 6)));
    const auto mesh = faces.mesh(1.0f);
    const MyPolygon& patch = mesh->patches[0];
    CHECK(patch.rad == Vec3f(4, 5, 6));
    CHECK(patch.unshot_rad == Vec3f(4, 5, 6));
    CHECK(patch.emissive == Vec3f(4, 5, 6));
    CHECK(patch.diffuse == Vec3f(0.1f, 0.2f, 0.3f));
    CHECK(patch.color == Vec3f(0.1f, 0.2f, 0.3f));
    CHECK(patch.formF == 0.0f);
}

TEST_CASE("emitters are cut to the light size, other faces to the patch size") {
    Faces faces;
    faces.add(square(0, true));
    faces.add(square(1, false), material(Vec3f(0.0f), Vec3f(1.0f)));
    const PatchMesh mesh(faces.positions, faces.faces, 0.5f, 0.1f);
    CHECK(std::count(mesh.faceOf.begin(), mesh.faceOf.end(), 0) == 4);
    CHECK(std::count(mesh.faceOf.begin(), mesh.faceOf.end(), 1) == 100);
}

TEST_CASE("sizes that are no positive numbers are refused") {
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    for (const float size : {0.0f, -1.0f, nan, infinity, -infinity})
        CHECK(errorOf(square(0, true), size).find("patch size: found") == 0);
    Faces faces;
    faces.add(square(0, true));
    CHECK_THROWS_WITH_AS(PatchMesh(faces.positions, faces.faces, 1.0f, -2.0f),
                         doctest::Contains("light patch size: found -2"), Error);
}

TEST_CASE("faces that cannot be patches are refused with their place in the file") {
    CHECK(errorOf({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 0, 0}}) ==
          "test.x3d:1: degenerate face: found 2 different corners, expected at least 3");
    CHECK(errorOf({{0, 0, 0}, {1, 0, 0}, {1, 1, 0.2f}, {0, 1, 0}})
              .find("test.x3d:1: face is not planar: found a corner") == 0);
    CHECK(errorOf({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0.0f}, {0.5f, 3, 0}}).find("crosses itself") !=
          std::string::npos);
    CHECK(errorOf(square(0, true), 1e-5f).find("test.x3d:1: too many patches") == 0);
}

TEST_CASE("a star of a thousand corners is cut in moderate time, one of more is refused") {
    const auto star = [](int corners) {
        std::vector<Vec3f> outline;
        for (int i = 0; i < corners; ++i) {
            const double angle = 2.0 * M_PI * i / corners, radius = i % 2 ? 0.9 : 1.0;
            outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0.0);
        }
        return outline;
    };
    CHECK(totalArea(meshOf(star(1000), 0.5f)) == Approx(0.5 * 1000 * 0.9 * std::sin(2.0 * M_PI / 1000)).epsilon(1e-4));
    CHECK(errorOf(star(2000)).find("too many corners: found 2000") != std::string::npos);
}

TEST_CASE("far from the origin, a face may be as far off its plane as float coordinates are coarse") {
    const float far = 1e6f;
    CHECK(meshOf({{far, far, far}, {far + 8, far, far}, {far + 8, far + 8, far + 0.0625f}, {far, far + 8, far}}, 1.0f)
              .patches.size() == 64);
}

TEST_CASE("faces without area are passed over with one warning that counts them") {
    Faces faces;
    faces.add({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
    faces.add(square(0, true));
    faces.add({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {2, 2, 2}});
    WarningCapture warnings;
    const auto mesh = faces.mesh(1.0f);
    CHECK(mesh->patches.size() == 1);
    CHECK(mesh->faceOf[0] == 1);
    REQUIRE(warnings.texts.size() == 1);
    CHECK(warnings.texts[0] == "test.x3d:1: passed over 2 faces, this the first, without area");
}

TEST_CASE("a scene of nothing but faces without area is refused") {
    WarningCapture warnings;
    CHECK(errorOf({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}).find("nothing to light") != std::string::npos);
}

TEST_CASE("thin strips stay patches at any scale") {
    for (const float scale : {1e-6f, 1.0f, 1e6f}) {
        CAPTURE(scale);
        const PatchMesh mesh =
            meshOf({{0, 0, 0}, {scale, 0, 0}, {scale, 1e-6f * scale, 0}, {0, 1e-6f * scale, 0}}, scale / 4);
        CHECK(mesh.patches.size() == 4);
        CHECK(mesh.patches[0].normal == Vec3f(0, 0, 1));
        CHECK(mesh.patches[0].area == Approx(0.25e-6 * scale * scale).epsilon(1e-5));
    }
}
