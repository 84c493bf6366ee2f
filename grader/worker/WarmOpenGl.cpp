#include "grader/worker/WarmOpenGl.h"

#include "base/Error.h"
#include "course/Hemicube.h"
#include "course/PatchMesh.h"
#include "gl/Framebuffer.h"
#include "gl/IdPass.h"
#include "gl/OpenGL.h"
#include "gl/SavedState.h"
#include "grader/worker/DrawIds.h"

namespace radlab::grader {

namespace {

constexpr int size = 16;  // pixels

// As submissions draw: in immediate mode and by arrays, triangles and more.
void drawBothWays() {
    for (const GLenum mode : {GL_TRIANGLES, GL_QUADS, GL_POLYGON}) {
        glBegin(mode);
        for (int i = 0; i < 12; ++i) {
            glColor3ub(1, 2, 3);
            glVertex3f(i % 4 < 2 ? 0.0f : 1.0f, i % 3 ? 0.0f : 1.0f, 0.5f);
        }
        glEnd();
    }
    drawIds();
}

void drawPicture() {
    const Framebuffer picture(size, size, Framebuffer::Color::bytes);
    SavedState saved;
    picture.bind();
    setIdPassState();
    glViewport(0, 0, size, size);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    drawBothWays();
    glFinish();
}

void drawHemicube() {
    Hemicube hemicube(size);
    hemicube.renderScene(Vec3f(0.0f), Vec3f(0.0f, 1.0f, 0.0f), Vec3f(0.0f, 0.0f, 1.0f), drawBothWays);
    hemicube.readIndexBuffer();
}

}  // namespace

std::unique_ptr<GlContext> warmOpenGl() {
    try {
        std::unique_ptr<GlContext> context = GlContext::offscreen();
        PatchMesh mesh;
        mesh.corners.resize(3);
        mesh.corners[1].position = Vec3f(1.0f, 0.0f, 0.5f);
        mesh.corners[2].position = Vec3f(0.0f, 1.0f, 0.5f);
        mesh.patches.resize(1);
        mesh.patches[0].vertices = 3;
        for (int i = 0; i < 3; ++i) mesh.patches[0].vertex[i] = i;
        mesh.publish();
        drawPicture();
        drawHemicube();
        return context;
    } catch (const Error&) {
        return nullptr;
    }
}

}  // namespace radlab::grader
