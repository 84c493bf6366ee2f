#include "display/Draw.h"

#include <cmath>

#include <doctest/doctest.h>

#include "course/Hemicube.h"
#include "course/TestMeshes.h"
#include "display/FalseColor.h"
#include "display/HemicubePicture.h"
#include "display/Label.h"
#include "display/ToneMap.h"
#include "gl/Context.h"

using namespace radlab;
using namespace radlab::test;
using doctest::Approx;

namespace {

// Looks at the square 0..1 in the plane z = 0 from the front, the square filling the middle half of the picture.
View viewOfSquare() {
    View view;
    view.width = view.height = 40;
    view.camera.position = Vec3f(0.5f, 0.5f, 1.0f);
    view.camera.fieldOfView = static_cast<float>(M_PI / 2);
    return view;
}

std::unique_ptr<PatchMesh> squareMesh(float size) {
    Faces faces;
    faces.add(square(0, true));
    auto mesh = faces.mesh(size);
    mesh->publish();
    return mesh;
}

}  // namespace

TEST_CASE("flat shading shows each patch in its own radiance, above 1 too, and background elsewhere") {
    const auto context = GlContext::offscreen();
    const auto mesh = squareMesh(0.5f);
    for (std::size_t i = 0; i < 4; ++i) polygons[i]->color = Vec3f(1.0f + i, 0.0f, 100.0f);
    View view = viewOfSquare();
    view.background = glm::vec3(0.25f);
    const Image image = drawRadiance(view, Shading::flat);
    CHECK(image.width() == 40);
    CHECK(image.at(15, 25) == glm::vec3(1, 0, 100));  // bottom left, row 0 is on top
    CHECK(image.at(25, 25) == glm::vec3(2, 0, 100));
    CHECK(image.at(15, 15) == glm::vec3(3, 0, 100));
    CHECK(image.at(25, 15) == glm::vec3(4, 0, 100));
    CHECK(image.at(2, 2) == glm::vec3(0.25f));
}

TEST_CASE("smooth shading runs linearly from vertex to vertex, without a diagonal") {
    const auto context = GlContext::offscreen();
    const auto mesh = squareMesh(1.0f);
    for (MyVertex* vertex : vertices) vertex->color = Vec3f(vertex->position.x * 10.0f, 0, 0);
    const Image image = drawRadiance(viewOfSquare(), Shading::smooth);
    for (int x = 11; x < 29; ++x)
        for (int y = 11; y < 29; ++y) {
            const double position = (x + 0.5 - 10.0) / 20.0;
            CHECK(image.at(x, y).r == Approx(10.0 * position).epsilon(0.01));
        }
}

TEST_CASE("the ID view shows what the drawing function drew, each ID in its false colour") {
    const auto context = GlContext::offscreen();
    const auto mesh = squareMesh(1.0f);
    const auto drawAs = [](int id) {
        return [id] {
            glColor3ub((id >> 16) & 255, (id >> 8) & 255, id & 255);
            glBegin(GL_QUADS);
            for (const int k : polygons[0]->vertex) glVertex3fv(&vertices[k]->position[0]);
            glEnd();
        };
    };
    for (const int id : {1, 77, 256, 65537}) {
        const Image image = drawIds(viewOfSquare(), drawAs(id));
        CHECK(image.at(20, 20) == idColor(static_cast<std::size_t>(id)));
        CHECK(image.at(2, 2) == glm::vec3(0.0f));
    }
    CHECK_THROWS_AS(drawIds(viewOfSquare(), [] { glBegin(GL_QUADS); }), Error);
}

TEST_CASE("a patch is not seen from its back") {
    const auto context = GlContext::offscreen();
    Faces faces;
    faces.add(square(0, false));
    const auto mesh = faces.mesh(1.0f);
    mesh->publish();
    polygons[0]->color = Vec3f(1);
    CHECK(drawRadiance(viewOfSquare(), Shading::flat).at(20, 20) == glm::vec3(0.0f));
}

TEST_CASE("a wider picture shows more at the sides and the same from top to bottom") {
    const auto context = GlContext::offscreen();
    const auto mesh = squareMesh(1.0f);
    polygons[0]->color = Vec3f(1);
    View view = viewOfSquare();
    view.width = 80;
    const Image image = drawRadiance(view, Shading::flat);
    CHECK(image.at(40, 11).r == Approx(1));
    CHECK(image.at(40, 8).r == 0.0f);
    CHECK(image.at(31, 20).r == Approx(1));
    CHECK(image.at(28, 20).r == 0.0f);
}

TEST_CASE("drawing leaves the OpenGL state as it was") {
    const auto context = GlContext::offscreen();
    const auto mesh = squareMesh(0.5f);
    glViewport(1, 2, 3, 4);
    glEnable(GL_LIGHTING);
    drawWireframe(viewOfSquare());
    GLint viewport[4];
    glGetIntegerv(GL_VIEWPORT, viewport);
    CHECK(viewport[2] == 3);
    CHECK(glIsEnabled(GL_LIGHTING));
    CHECK(glGetError() == GL_NO_ERROR);
}

TEST_CASE("the wireframe shows dark lines between patches and light inside") {
    const auto context = GlContext::offscreen();
    const auto mesh = squareMesh(0.5f);
    View view = viewOfSquare();
    view.width = view.height = 200;
    const Image image = drawWireframe(view);
    CHECK(image.at(100, 75).r < 0.8f * image.at(75, 75).r);
    CHECK(image.at(75, 100).r < 0.8f * image.at(75, 75).r);
}

TEST_CASE("tone mapping is exposure, clamping and the sRGB curve") {
    Image radiance(2, 1);
    radiance.at(0, 0) = {0.5f, -1.0f, 7.0f};
    radiance.at(1, 0) = {0.25f, 0.001f, 0.0f};
    const Image shown = toneMap(radiance, 2.0f);
    CHECK(glm::distance(shown.at(0, 0), glm::vec3(1, 0, 1)) < 1e-6f);
    CHECK(shown.at(1, 0).r == Approx(0.735357).epsilon(1e-5));  // sRGB of 0.5 [IEC61966]
    CHECK(shown.at(1, 0).g == Approx(0.002 * 12.92));
    CHECK(srgbFromLinear(1.0f) == Approx(1.0));
    CHECK(srgbFromLinear(0.0031308f) == Approx(0.04045).epsilon(1e-4));
}

TEST_CASE("the automatic exposure is the same picture for any unit of light, and 1 for black") {
    Image radiance(10, 10);
    for (int i = 0; i < 100; ++i) radiance.at(i % 10, i / 10) = glm::vec3(static_cast<float>(i));
    Image brighter = radiance;
    for (glm::vec3& pixel : brighter.data()) pixel *= 1e6f;
    CHECK(autoExposure(radiance) == Approx(1e6 * autoExposure(brighter)));
    CHECK(autoExposure(Image(3, 3)) == 1.0f);
    const Image shown = toneMap(radiance, autoExposure(radiance));
    CHECK(shown.at(5, 9).r < 1.0f);
    CHECK(shown.at(9, 9).r > shown.at(5, 9).r);
}

TEST_CASE("ID colours of the first ten thousand patches differ, and 0 is black") {
    CHECK(idColor(0) == glm::vec3(0.0f));
    for (std::size_t id = 1; id < 10000; ++id) {
        const glm::vec3 color = idColor(id);
        CHECK(glm::distance(color, idColor(id + 1)) > 0.1f);
        CHECK(std::fmin(color.r, std::fmin(color.g, color.b)) >= 0.0f);
        CHECK(std::fmax(color.r, std::fmax(color.g, color.b)) <= 1.0f);
    }
}

TEST_CASE("heat colours get lighter with the share and end at both ends") {
    const auto lightness = [](const glm::vec3& c) { return 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b; };
    for (int i = 0; i < 100; ++i) CHECK(lightness(heatColor(0.01f * i)) < lightness(heatColor(0.01f * (i + 1))));
    CHECK(heatColor(-1.0f) == heatColor(0.0f));
    CHECK(heatColor(5.0f) == heatColor(1.0f));
    CHECK(heatColor(std::nanf("")) == heatColor(0.0f));
    CHECK(formFactorColor(0.0f) == heatColor(0.0f));
    CHECK(formFactorColor(1e-2f) == heatColor(1.0f));
}

TEST_CASE("a hemicube unfolded shows the top face in the middle and grey in the unused corners") {
    const auto context = GlContext::offscreen();
    Faces room;
    room.addRoom(Vec3f(-1), Vec3f(1), material(Vec3f(0.5f)));
    const auto mesh = room.mesh(10.0f);
    mesh->publish();
    Hemicube hemicube(16);
    hemicube.renderScene(Vec3f(0, -0.999f, 0), Vec3f(0, 0, 1), Vec3f(0, 1, 0), [] {
        for (std::size_t i = 0; i < polygons.size(); ++i) {
            glColor3ub(0, 0, static_cast<GLubyte>(i + 1));
            glBegin(GL_QUADS);
            for (const int k : polygons[i]->vertex) glVertex3fv(&vertices[k]->position[0]);
            glEnd();
        }
    });
    hemicube.readIndexBuffer();
    const Image image = hemicubeIds(hemicube);
    CHECK(image.at(16, 16) == idColor(2));  // the ceiling, straight on
    CHECK(image.at(16, 0) == idColor(4));   // up is z: the wall at z = 1 on top
    CHECK(image.at(16, 31) == idColor(3));
    CHECK(image.at(0, 0) == glm::vec3(0.13f));
    CHECK(hemicubeWeights(hemicube).at(16, 16) == heatColor(1.0f));
}

TEST_CASE("text marks pixels inside its width only, and is cut off at the picture's edge") {
    const int width = textWidth("form factor", 2);
    CHECK(width > 0);
    CHECK(textWidth("form factor form factor", 2) > 2 * width);
    Image image(width + 20, 30);
    writeText(image, 5, 5, "form factor", 2, glm::vec3(1.0f));
    int inside = 0, outside = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (image.at(x, y).r > 0.0f) ++(x >= 5 && x < 5 + width && y >= 5 && y < 29 ? inside : outside);
    CHECK(inside > 50);
    CHECK(outside == 0);
    Image small(3, 3);
    CHECK_NOTHROW(writeText(small, -5, -5, "form factor", 3, glm::vec3(1.0f)));
}

TEST_CASE("a contact sheet holds every picture under its title") {
    const std::vector<Image> pictures(3, Image(50, 40, glm::vec3(1, 0, 0)));
    const Image sheet = contactSheet(pictures, {"one", "two", "three"}, 2);
    int red = 0;
    for (const glm::vec3& pixel : sheet.data()) red += pixel == glm::vec3(1, 0, 0);
    CHECK(red == 3 * 50 * 40);
}
