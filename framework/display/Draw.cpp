#include "display/Draw.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "base/Error.h"
#include "course/ViewDepth.h"
#include "display/FalseColor.h"
#include "display/ToneMap.h"
#include "gl/Context.h"
#include "gl/Framebuffer.h"
#include "gl/IdPass.h"
#include "gl/SavedState.h"

namespace radlab {

namespace {

// Colours beyond 0..1 go through as they are.
void turnClampingOff() {
    constexpr GLenum clampVertexColor = 0x891a, clampFragmentColor = 0x891b, clampReadColor = 0x891c;
    if (!gl().clampColor) return;
    for (const GLenum target : {clampVertexColor, clampFragmentColor, clampReadColor})
        gl().clampColor(target, GL_FALSE);
}

Image readImage(const Framebuffer& framebuffer) {
    Image image(framebuffer.width(), framebuffer.height());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_PACK_ROW_LENGTH, 0);
    for (int y = 0; y < image.height(); ++y)
        glReadPixels(0, image.height() - 1 - y, image.width(), 1, GL_RGB, GL_FLOAT, &image.at(0, y));
    return image;
}

// Makes the framebuffer ready for colours that arrive as they are, and clears it.
void beginDrawing(const View& view, const Framebuffer& framebuffer, const glm::vec3& background) {
    framebuffer.bind();
    setIdPassState();
    glDisable(GL_SCISSOR_TEST);
    glViewport(0, 0, framebuffer.width(), framebuffer.height());
    glClearColor(background.r, background.g, background.b, 0.0f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    setCamera(view);
}

Image drawInto(const View& view, const std::function<void()>& draw) {
    RADLAB_CHECK(view.samples >= 1);
    const SavedState saved;
    const Framebuffer framebuffer(view.width * view.samples, view.height * view.samples, Framebuffer::Color::floats);
    beginDrawing(view, framebuffer, view.background);
    turnClampingOff();
    glShadeModel(GL_SMOOTH);
    glEnable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    draw();
    return readImage(framebuffer).shrunk(view.samples);
}

const Vec3f& corner(const MyPolygon& patch, int i) {
    return vertices[static_cast<std::size_t>(patch.vertex[i % patch.vertices])]->position;
}

void drawFlat(const std::function<glm::vec3(std::size_t)>& color) {
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        const glm::vec3 shown = color(i);
        glBegin(GL_POLYGON);
        glColor3fv(&shown[0]);
        for (int k = 0; k < polygons[i]->vertices; ++k) glVertex3fv(&corner(*polygons[i], k)[0]);
        glEnd();
    }
}

// A fan round the middle, so that a quadrilateral shows no diagonal.
void drawSmooth(const MyPolygon& patch) {
    glm::vec3 middle(0.0f), mean(0.0f);
    for (int k = 0; k < patch.vertices; ++k) {
        middle += corner(patch, k) / static_cast<float>(patch.vertices);
        mean += vertices[static_cast<std::size_t>(patch.vertex[k])]->color / static_cast<float>(patch.vertices);
    }
    glBegin(GL_TRIANGLE_FAN);
    glColor3fv(&mean[0]);
    glVertex3fv(&middle[0]);
    for (int k = 0; k <= patch.vertices; ++k) {
        glColor3fv(&vertices[static_cast<std::size_t>(patch.vertex[k % patch.vertices])]->color[0]);
        glVertex3fv(&corner(patch, k)[0]);
    }
    glEnd();
}

void drawOutlines(int samples) {
    glDisable(GL_CULL_FACE);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_LEQUAL);
    glLineWidth(static_cast<float>(samples));
    glColor3f(0.02f, 0.03f, 0.05f);
    for (const MyPolygon* patch : polygons) {
        glBegin(GL_LINE_LOOP);
        for (int k = 0; k < patch->vertices; ++k) glVertex3fv(&corner(*patch, k)[0]);
        glEnd();
    }
}

}  // namespace

void setCamera(const View& view) {
    const Camera& camera = view.camera;
    const glm::dvec3 eye(camera.position), direction(camera.direction);
    const ViewDepth depth = viewDepth(polygons, vertices, eye, direction);
    // What is d away and inside the picture lies at least d times the cosine of its corner deep.
    const double nearest = 0.25 * depth.nearest;
    const double half = nearest * std::tan(0.5 * static_cast<double>(camera.fieldOfView));
    const double smaller = std::min(view.width, view.height);
    const double x = half * view.width / smaller, y = half * view.height / smaller;
    glMatrixMode(GL_PROJECTION);
    glLoadMatrixd(glm::value_ptr(glm::frustum(-x, x, -y, y, nearest, depth.farthest)));
    glMatrixMode(GL_MODELVIEW);
    glLoadMatrixd(glm::value_ptr(glm::lookAt(eye, eye + direction, glm::dvec3(camera.up))));
}

glm::vec3 unlitColor(const MyPolygon& patch) {
    const bool emits = patch.emissive != Vec3f(0.0f);
    return emits ? glm::vec3(1.0f, 0.9f, 0.5f) : 0.25f + 0.7f * patch.diffuse;
}

Image drawRadiance(const View& view, Shading shading) {
    return drawInto(view, [&] {
        if (shading == Shading::flat)
            drawFlat([](std::size_t i) { return polygons[i]->color; });
        else
            for (const MyPolygon* patch : polygons) drawSmooth(*patch);
    });
}

Image drawColors(const View& view, const std::function<glm::vec3(std::size_t)>& color) {
    return drawInto(view, [&] { drawFlat(color); });
}

std::vector<std::uint32_t> readIds(const View& view, const std::function<void()>& draw) {
    SavedState saved;
    const Framebuffer framebuffer(view.width * view.samples, view.height * view.samples, Framebuffer::Color::bytes);
    beginDrawing(view, framebuffer, glm::vec3(0.0f));
    draw();
    saved.checkBalance();
    std::vector<std::uint8_t> bytes(std::size_t{4} *
                                    static_cast<std::size_t>(framebuffer.width() * framebuffer.height()));
    framebuffer.bind();
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_PACK_ROW_LENGTH, 0);
    glReadPixels(0, 0, framebuffer.width(), framebuffer.height(), GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    std::vector<std::uint32_t> ids(bytes.size() / 4);
    for (std::size_t i = 0; i < ids.size(); ++i)
        ids[i] = std::uint32_t{bytes[4 * i]} << 16 | std::uint32_t{bytes[4 * i + 1]} << 8 | bytes[4 * i + 2];
    return ids;
}

Image drawIds(const View& view, const std::function<void()>& draw) {
    const std::vector<std::uint32_t> ids = readIds(view, draw);
    Image image(view.width * view.samples, view.height * view.samples);
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            image.at(x, image.height() - 1 - y) = idColor(ids[static_cast<std::size_t>(y * image.width() + x)]);
    return image.shrunk(view.samples);
}

Image drawWireframe(const View& view) {
    View fine = view;
    fine.samples = std::max(view.samples, 4);
    const Image lines = drawInto(fine, [&] {
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(1.0f, 2.0f);
        drawFlat([](std::size_t i) { return unlitColor(*polygons[i]); });
        drawOutlines(fine.samples);
    });
    return toneMap(lines, 1.0f);
}

}  // namespace radlab
