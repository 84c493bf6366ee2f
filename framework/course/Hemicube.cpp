#include "course/Hemicube.h"

#include <array>
#include <cmath>
#include <string>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "base/Error.h"
#include "course/DataFormat.h"
#include "course/DeltaFormFactors.h"
#include "course/ViewDepth.h"
#include "gl/Context.h"
#include "gl/Framebuffer.h"
#include "gl/IdPass.h"
#include "gl/SavedState.h"

using radlab::Error;
using radlab::Framebuffer;

namespace {

// Below this sine of the angle between them, up and direction count as parallel.
constexpr double parallelSine = 1e-5;

int checkedSize(int size) {
    if (size < 2 || size % 2 != 0)
        throw Error("hemicube size: found " + std::to_string(size) + ", expected an even number of at least 2");
    return size;
}

bool finite(const Vec3f& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

std::string text(const Vec3f& v) {
    return "(" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + ")";
}

glm::dvec3 unit(const Vec3f& v, const std::string& name) {
    const glm::dvec3 exact(v);
    if (!finite(v) || glm::length(exact) == 0.0)
        throw Error("Hemicube::renderScene: " + name + " vector: found " + text(v) + ", expected finite and not zero");
    return glm::normalize(exact);
}

// The patch's frame: right, up and direction at right angles.
struct Frame {
    glm::dvec3 eye, right, up, direction;
};

Frame frameOf(const Vec3f& eye, const Vec3f& up, const Vec3f& direction) {
    if (!finite(eye)) throw Error("Hemicube::renderScene: eye: found " + text(eye) + ", expected a finite position");
    const glm::dvec3 forward = unit(direction, "direction");
    const glm::dvec3 right = glm::cross(forward, unit(up, "up"));
    if (glm::length(right) < parallelSine)
        throw Error("Hemicube::renderScene: up vector: found " + text(up) + ", parallel to the direction " +
                    text(direction) + "; expected a vector in the plane of the patch");
    const glm::dvec3 unitRight = glm::normalize(right);
    return {glm::dvec3(eye), unitRight, glm::cross(unitRight, forward), forward};
}

// One view: where it looks, where it lies in the buffer (in halves of size) and what part of ±1 it shows.
struct View {
    glm::dvec3 forward, up;
    int x, y, width, height;
    double left, right, bottom, top;
};

std::array<View, 5> viewsOf(const Frame& f) {
    return {{{f.direction, f.up, 1, 1, 2, 2, -1, 1, -1, 1},
             {f.right, f.up, 3, 1, 1, 2, -1, 0, -1, 1},
             {-f.right, f.up, 0, 1, 1, 2, 0, 1, -1, 1},
             {f.up, -f.direction, 1, 3, 2, 1, -1, 1, -1, 0},
             {-f.up, f.direction, 1, 0, 2, 1, -1, 1, 0, 1}}};
}

void loadMatrix(GLenum mode, const glm::dmat4& matrix) {
    glMatrixMode(mode);
    glLoadMatrixd(glm::value_ptr(matrix));
}

void setView(const View& view, const glm::dvec3& eye, const radlab::ViewDepth& depth, int half) {
    glViewport(view.x * half, view.y * half, view.width * half, view.height * half);
    // Keeps a callback that clears the buffer from clearing the other faces.
    glScissor(view.x * half, view.y * half, view.width * half, view.height * half);
    glEnable(GL_SCISSOR_TEST);
    const double n = depth.nearest;
    loadMatrix(GL_PROJECTION,
               glm::frustum(view.left * n, view.right * n, view.bottom * n, view.top * n, n, depth.farthest));
    loadMatrix(GL_MODELVIEW, glm::lookAt(eye, eye + view.forward, view.up));
}

void clear() {
    const radlab::SavedState saved;
    radlab::setIdPassState();
    glDisable(GL_SCISSOR_TEST);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

}  // namespace

Hemicube::Hemicube(int size)
    : rendersize(2 * checkedSize(size)),
      framebuffer(std::make_unique<Framebuffer>(rendersize, rendersize, Framebuffer::Color::bytes)),
      pixels(4 * static_cast<std::size_t>(rendersize) * static_cast<std::size_t>(rendersize), 0),
      deltas(radlab::deltaFormFactors(size)) {}

Hemicube::~Hemicube() = default;

void Hemicube::renderScene(const Vec3f& eye, const Vec3f& up, const Vec3f& direction,
                           const std::function<void()>& draw) {
    const Frame frame = frameOf(eye, up, direction);
    const radlab::ViewDepth depth = radlab::viewDepth(polygons, vertices, frame.eye, frame.direction);
    bool first = true;
    for (const View& view : viewsOf(frame)) {
        radlab::SavedState saved;
        framebuffer->bind();
        if (first) clear();
        first = false;
        radlab::setIdPassState();
        setView(view, frame.eye, depth, rendersize / 4);
        draw();
        saved.checkBalance();
    }
}

void Hemicube::readIndexBuffer() {
    const radlab::SavedState saved;
    framebuffer->bind();
    radlab::gl().bindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    for (const GLenum name :
         {GL_PACK_SWAP_BYTES, GL_PACK_LSB_FIRST, GL_PACK_ROW_LENGTH, GL_PACK_SKIP_ROWS, GL_PACK_SKIP_PIXELS})
        glPixelStorei(name, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, rendersize, rendersize, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
}

void Hemicube::outside(int x, int y) const {
    throw Error("hemicube pixel: found (" + std::to_string(x) + ", " + std::to_string(y) + "), expected 0 to " +
                std::to_string(rendersize - 1) + " each way");
}
