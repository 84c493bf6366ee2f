#include "gl/window/Window.h"

#include <cstdlib>

#include <doctest/doctest.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "base/Error.h"
#include "base/Stopwatch.h"
#include "base/TestSkip.h"
#include "course/Hemicube.h"
#include "course/TestMeshes.h"

using namespace radlab;
using namespace radlab::test;
using doctest::Approx;

namespace {

// Whether there is something to open a window on.
bool hasDisplay() {
#if defined(__linux__)
    const auto set = [](const char* name) { return std::getenv(name) && *std::getenv(name); };
    return set("DISPLAY") || set("WAYLAND_DISPLAY");
#else
    return true;
#endif
}

void skippedWithoutDisplay() { skipped("there is neither a display nor xvfb-run"); }

void drawIds() {
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        glBegin(GL_QUADS);
        glColor3ub(0, ((i + 1) >> 8) & 255, (i + 1) & 255);
        for (const int corner : polygons[i]->vertex) glVertex3fv(&vertices[corner]->position[0]);
        glEnd();
    }
}

std::vector<double> row(Hemicube& hemicube, const MyPolygon& shooter) {
    hemicube.renderScene(shooter.center, vertices[shooter.vertex[0]]->position - shooter.center, shooter.normal,
                         drawIds);
    hemicube.readIndexBuffer();
    std::vector<double> factors(polygons.size());
    for (int y = 0; y < hemicube.rendersize; ++y)
        for (int x = 0; x < hemicube.rendersize; ++x)
            if (const int id = hemicube.getIndex(x, y); id > 0)
                factors.at(static_cast<std::size_t>(id - 1)) += hemicube.getDeltaFormFactor(x, y);
    return factors;
}

// Whether it is shown, or hidden, within some minutes: a display takes its time to do so.
bool becomes(const Window& window, bool visible) {
    const Stopwatch watch;
    while ((glfwGetWindowAttrib(window.handle(), GLFW_VISIBLE) == GLFW_TRUE) != visible)
        if (watch.seconds() > 300.0)
            return false;
        else
            glfwWaitEventsTimeout(0.02);
    return true;
}

double sum(const std::vector<double>& values) {
    double total = 0.0;
    for (const double value : values) total += value;
    return total;
}

std::unique_ptr<PatchMesh> cube() {
    Faces room;
    room.addRoom(Vec3f(0), Vec3f(1), material(Vec3f(0.5f)));
    auto mesh = room.mesh(0.25f);
    mesh->publish();
    return mesh;
}

}  // namespace

TEST_CASE("a hemicube in a window gives a closed cube's rows, whatever the window's size, shown or hidden") {
    if (!hasDisplay()) return skippedWithoutDisplay();
    const auto mesh = cube();
    std::vector<std::vector<double>> rows;
    for (const bool visible : {false, true})
        for (const auto& [width, height] : {std::pair{40, 30}, {1, 1}, {300, 200}}) {
            CAPTURE(visible);
            const int columns = width;
            CAPTURE(columns);
            Window window(width, height, "radlab test", visible);
            window.makeCurrent();
            Hemicube hemicube(64);
            for (std::size_t s = 0; s < polygons.size(); s += 13)
                CHECK(sum(row(hemicube, *polygons[s])) == Approx(1.0).epsilon(1e-6));
            rows.push_back(row(hemicube, *polygons[5]));
            CHECK(glGetError() == GL_NO_ERROR);
        }
    for (const std::vector<double>& other : rows) CHECK(other == rows[0]);
}

TEST_CASE("a window says what it is, is shown or hidden as asked, and has the size asked for") {
    if (!hasDisplay()) return skippedWithoutDisplay();
    for (const bool visible : {false, true}) {
        Window window(120, 90, "radlab test", visible);
        window.makeCurrent();
        CHECK(window.kind() == "GLFW");
        CHECK(&GlContext::current() == &window);
        CHECK(becomes(window, visible));
        int width = 0, height = 0;
        glfwGetWindowSize(window.handle(), &width, &height);
        CHECK(width == 120);
        CHECK(height == 90);
    }
    CHECK_THROWS_AS(GlContext::current(), Error);
}

TEST_CASE("two windows live beside each other, and the second outlives the first") {
    if (!hasDisplay()) return skippedWithoutDisplay();
    const auto mesh = cube();
    auto first = std::make_unique<Window>(40, 30, "first", false);
    Window second(50, 60, "second", false);
    first->makeCurrent();
    CHECK(sum(row(*std::make_unique<Hemicube>(32), *polygons[0])) == Approx(1.0).epsilon(1e-6));
    first.reset();
    second.makeCurrent();
    CHECK(sum(row(*std::make_unique<Hemicube>(32), *polygons[0])) == Approx(1.0).epsilon(1e-6));
    CHECK(glGetError() == GL_NO_ERROR);
}

TEST_CASE("the offscreen context of a program with a window is a hidden window") {
    if (!hasDisplay()) return skippedWithoutDisplay();
    setenv("RADLAB_GL", "window", 1);
    const auto context = GlContext::offscreen();
    CHECK(context->kind() == "GLFW");
    setenv("RADLAB_GL", "osmesa", 1);
    CHECK_THROWS_WITH_AS(GlContext::offscreen(), doctest::Contains("found 'osmesa', expected window"), Error);
    unsetenv("RADLAB_GL");
}
