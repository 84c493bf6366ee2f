#include "gl/SavedState.h"

#include <functional>
#include <string>

#include <doctest/doctest.h>

#include "base/Error.h"
#include "gl/Context.h"
#include "gl/Framebuffer.h"
#include "gl/IdPass.h"

using namespace radlab;

namespace {

// What a program can see of the state, as numbers.
std::vector<double> snapshot() {
    std::vector<double> values;
    for (const GLenum capability :
         {GL_DITHER, GL_BLEND, GL_MULTISAMPLE, GL_LIGHTING, GL_FOG, GL_TEXTURE_2D, GL_CULL_FACE, GL_DEPTH_TEST,
          GL_SCISSOR_TEST, GL_LIGHT0, GL_LIGHT3, GL_CLIP_PLANE2, GL_NORMALIZE, GL_COLOR_MATERIAL, GL_VERTEX_ARRAY,
          GL_COLOR_ARRAY, GL_POLYGON_OFFSET_FILL})
        values.push_back(glIsEnabled(capability));
    for (const GLenum name : {GL_VIEWPORT,
                              GL_SCISSOR_BOX,
                              GL_COLOR_CLEAR_VALUE,
                              GL_COLOR_WRITEMASK,
                              GL_DEPTH_FUNC,
                              GL_DEPTH_WRITEMASK,
                              GL_DEPTH_RANGE,
                              GL_POLYGON_MODE,
                              GL_SHADE_MODEL,
                              GL_FRONT_FACE,
                              GL_CULL_FACE_MODE,
                              GL_BLEND_SRC,
                              GL_BLEND_DST,
                              GL_CURRENT_COLOR,
                              GL_CURRENT_NORMAL,
                              GL_LINE_WIDTH,
                              GL_POINT_SIZE,
                              GL_PACK_ALIGNMENT,
                              GL_UNPACK_ALIGNMENT,
                              GL_PACK_ROW_LENGTH,
                              GL_MATRIX_MODE,
                              GL_MODELVIEW_MATRIX,
                              GL_PROJECTION_MATRIX,
                              GL_TEXTURE_MATRIX,
                              GL_MODELVIEW_STACK_DEPTH,
                              GL_PROJECTION_STACK_DEPTH,
                              GL_ATTRIB_STACK_DEPTH,
                              GL_CLIENT_ATTRIB_STACK_DEPTH,
                              GL_DRAW_FRAMEBUFFER_BINDING,
                              GL_READ_FRAMEBUFFER_BINDING,
                              GL_CURRENT_PROGRAM,
                              GL_ARRAY_BUFFER_BINDING,
                              GL_RENDER_MODE,
                              GL_LIST_INDEX,
                              GL_FOG_COLOR,
                              GL_LIGHT_MODEL_AMBIENT,
                              GL_ALPHA_TEST_FUNC,
                              GL_STENCIL_FUNC,
                              GL_LOGIC_OP_MODE,
                              GL_POLYGON_OFFSET_FACTOR,
                              GL_TEXTURE_BINDING_2D,
                              GL_ACTIVE_TEXTURE}) {
        GLdouble value[16] = {};
        glGetDoublev(name, value);
        values.insert(values.end(), value, value + 16);
    }
    values.push_back(glGetError());
    return values;
}

// Puts the context into a state that differs from the default in most things.
void unusualState() {
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glTranslated(1, 2, 3);
    glPushMatrix();
    glRotated(30, 0, 1, 1);
    glMatrixMode(GL_PROJECTION);
    glFrustum(-1, 1, -1, 1, 1, 10);
    glViewport(3, 4, 50, 60);
    glEnable(GL_LIGHTING);
    glEnable(GL_FOG);
    glDisable(GL_DITHER);
    glClearColor(0.1f, 0.2f, 0.3f, 0.4f);
    glPixelStorei(GL_PACK_ALIGNMENT, 2);
    glColor3f(0.5f, 0.25f, 0.125f);
    glPushAttrib(GL_CURRENT_BIT);
}

void checkUndone(const char* name, const std::function<void()>& abuse) {
    CAPTURE(name);
    const auto context = GlContext::offscreen();
    unusualState();
    const std::vector<double> before = snapshot();
    {
        const SavedState saved;
        setIdPassState();
        abuse();
    }
    const std::vector<double> after = snapshot();
    CHECK(after == before);
    // The stacks' lower levels are as they were, too.
    glMatrixMode(GL_MODELVIEW);
    glPopMatrix();
    GLdouble matrix[16];
    glGetDoublev(GL_MODELVIEW_MATRIX, matrix);
    CHECK(matrix[12] == 1.0);
    CHECK(matrix[14] == 3.0);
    glColor3f(1, 1, 1);
    glPopAttrib();
    GLdouble color[4];
    glGetDoublev(GL_CURRENT_COLOR, color);
    CHECK(color[1] == 0.25);
    CHECK(glGetError() == GL_NO_ERROR);
}

}  // namespace

TEST_CASE("the state of a drawing is undone") {
    checkUndone("nothing", [] {});
    checkUndone("capabilities", [] {
        for (const GLenum capability : {GL_BLEND, GL_LIGHT3, GL_CULL_FACE, GL_CLIP_PLANE2, GL_NORMALIZE,
                                        GL_SCISSOR_TEST, GL_POLYGON_OFFSET_FILL, GL_COLOR_MATERIAL})
            glEnable(capability);
        glDisable(GL_LIGHTING);
    });
    checkUndone("values", [] {
        glViewport(0, 0, 1, 1);
        glClearColor(1, 1, 1, 1);
        glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
        glDepthFunc(GL_ALWAYS);
        glDepthRange(0.3, 0.4);
        glBlendFunc(GL_ONE, GL_ONE);
        glLineWidth(3);
        glPixelStorei(GL_PACK_ALIGNMENT, 8);
        glPixelStorei(GL_PACK_ROW_LENGTH, 99);
        glFrontFace(GL_CW);
        glColor3f(1, 0, 0);
    });
    checkUndone("matrices", [] {
        for (const GLenum mode : {GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE}) {
            glMatrixMode(mode);
            glLoadIdentity();
            glScaled(2, 2, 2);
        }
    });
    checkUndone("objects", [] {
        const Framebuffer other(8, 8, Framebuffer::Color::bytes);
        other.bind();
        GLuint texture = 0;
        glGenTextures(1, &texture);
        glBindTexture(GL_TEXTURE_2D, texture);
        static const float points[] = {0, 0, 0};
        glEnableClientState(GL_VERTEX_ARRAY);
        glVertexPointer(3, GL_FLOAT, 0, points);
    });
}

TEST_CASE("what a drawing leaves open or unbalanced is undone, too") {
    checkUndone("open primitive", [] { glBegin(GL_QUADS); });
    checkUndone("open display list", [] { glNewList(glGenLists(1), GL_COMPILE); });
    checkUndone("selection", [] { glRenderMode(GL_SELECT); });
    checkUndone("pushed too often", [] {
        for (int i = 0; i < 20; ++i) {
            glMatrixMode(GL_MODELVIEW);
            glPushMatrix();
            glMatrixMode(GL_PROJECTION);
            glPushMatrix();
            glPushAttrib(GL_ALL_ATTRIB_BITS);
            glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
            glEnable(GL_BLEND);
        }
    });
    checkUndone("matrices popped far too often", [] {
        glMatrixMode(GL_MODELVIEW);
        for (int i = 0; i < 1000; ++i) glPopMatrix();
        glLoadIdentity();
    });
    checkUndone("attributes popped once too often", [] {
        glPopAttrib();
        glEnable(GL_BLEND);
        glPopClientAttrib();
        glPixelStorei(GL_PACK_ALIGNMENT, 4);
    });
    checkUndone("an error", [] { glEnable(GL_QUADS + 12345); });
    checkUndone("an exception", [] {
        try {
            const SavedState inner;
            glEnable(GL_BLEND);
            throw NotImplemented("renderPatchIDs");
        } catch (const NotImplemented&) {
        }
    });
}

TEST_CASE("a drawing that leaves glBegin open or pops too much is told so") {
    const auto context = GlContext::offscreen();
    const Framebuffer framebuffer(4, 4, Framebuffer::Color::bytes);
    framebuffer.bind();  // without one, glBegin is an error of its own and opens nothing
    {
        SavedState saved;
        CHECK_NOTHROW(saved.checkBalance());
        glBegin(GL_TRIANGLES);
        CHECK_THROWS_WITH_AS(saved.checkBalance(), doctest::Contains("each glBegin needs its glEnd"), Error);
    }
    SavedState saved;
    glPopAttrib();
    CHECK_THROWS_WITH_AS(saved.checkBalance(), doctest::Contains("pops more attributes"), Error);
}

TEST_CASE("a context that was drawn in outside any framebuffer object goes quietly") {
    const auto context = GlContext::offscreen();
    glBegin(GL_TRIANGLES);
    for (const float x : {-1.0f, 1.0f, 0.0f}) glVertex2f(x, 2.0f * x * x - 1.0f);
    glEnd();
}

TEST_CASE("another RADLAB_GL than the program was built with is refused with the name that it takes") {
    const char* before = std::getenv("RADLAB_GL");
    const std::string kept = before ? before : "";
    setenv("RADLAB_GL", "direct3d", 1);
    const std::string expected = "found 'direct3d', expected " + GlContext::offscreenKind();
    CHECK_THROWS_WITH_AS(GlContext::offscreen(), doctest::Contains(expected.c_str()), Error);
    setenv("RADLAB_GL", kept.c_str(), 1);
    CHECK_NOTHROW(GlContext::offscreen());
}

TEST_CASE("without a context there is a message, not a crash") {
    CHECK_THROWS_WITH_AS(GlContext::current(), doctest::Contains("no OpenGL context is current"), Error);
}
