#include "gl/SavedState.h"

#include "base/Error.h"
#include "gl/Context.h"

namespace radlab {

namespace {

// How many attribute pops too many are survived.
constexpr int spareCopies = 3;

GLint integer(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

void clearErrors() {
    for (int i = 0; i < 16 && glGetError() != GL_NO_ERROR; ++i) {
    }
}

}  // namespace

SavedState::SavedState()
    : stacks{{{GL_MODELVIEW, GL_MODELVIEW_STACK_DEPTH, GL_MODELVIEW_MATRIX, {}},
              {GL_PROJECTION, GL_PROJECTION_STACK_DEPTH, GL_PROJECTION_MATRIX, {}},
              {GL_TEXTURE, GL_TEXTURE_STACK_DEPTH, GL_TEXTURE_MATRIX, {}}}} {
    readMatrices();
    readBindings();
    pushAttributes();
    clearErrors();
}

SavedState::~SavedState() {
    endWhatIsOpen();
    restoreAttributes();
    restoreBindings();
    restoreMatrices();
    clearErrors();
}

void SavedState::checkBalance() {
    constexpr GLint unanswered = -1;
    GLint answer = unanswered;
    glGetIntegerv(GL_MATRIX_MODE, &answer);  // between glBegin and glEnd nothing can be asked
    glEnd();
    if (answer == unanswered)
        throw Error("the drawing function ends between glBegin and glEnd: each glBegin needs its glEnd");
    if (integer(GL_ATTRIB_STACK_DEPTH) < attributeDepth + spareCopies ||
        integer(GL_CLIENT_ATTRIB_STACK_DEPTH) < clientAttributeDepth + spareCopies)
        throw Error(
            "the drawing function pops more attributes than it pushed: each glPopAttrib needs its glPushAttrib");
}

void SavedState::endWhatIsOpen() {
    glEnd();
    glEndList();
    glRenderMode(GL_RENDER);
}

void SavedState::readMatrices() {
    matrixMode = integer(GL_MATRIX_MODE);
    for (MatrixStack& stack : stacks) {
        glMatrixMode(stack.mode);
        stack.levels.resize(static_cast<std::size_t>(integer(stack.depthName)));
        for (std::size_t i = stack.levels.size(); i-- > 0;) {
            glGetDoublev(stack.matrixName, stack.levels[i].data());
            if (i > 0) glPopMatrix();
        }
        for (std::size_t i = 1; i < stack.levels.size(); ++i) {
            glPushMatrix();
            glLoadMatrixd(stack.levels[i].data());
        }
    }
    glMatrixMode(static_cast<GLenum>(matrixMode));
}

void SavedState::restoreMatrices() {
    for (const MatrixStack& stack : stacks) {
        glMatrixMode(stack.mode);
        for (GLint extra = integer(stack.depthName) - 1; extra > 0; --extra) glPopMatrix();
        glLoadMatrixd(stack.levels[0].data());
        for (std::size_t i = 1; i < stack.levels.size(); ++i) {
            glPushMatrix();
            glLoadMatrixd(stack.levels[i].data());
        }
    }
    glMatrixMode(static_cast<GLenum>(matrixMode));
}

void SavedState::pushAttributes() {
    attributeDepth = integer(GL_ATTRIB_STACK_DEPTH);
    clientAttributeDepth = integer(GL_CLIENT_ATTRIB_STACK_DEPTH);
    for (int i = 0; i < spareCopies; ++i) {
        glPushAttrib(GL_ALL_ATTRIB_BITS);
        glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
    }
}

void SavedState::restoreAttributes() {
    while (integer(GL_ATTRIB_STACK_DEPTH) > attributeDepth) glPopAttrib();
    while (integer(GL_CLIENT_ATTRIB_STACK_DEPTH) > clientAttributeDepth) glPopClientAttrib();
}

void SavedState::readBindings() {
    drawFramebuffer = integer(GL_DRAW_FRAMEBUFFER_BINDING);
    readFramebuffer = integer(GL_READ_FRAMEBUFFER_BINDING);
    renderbuffer = integer(GL_RENDERBUFFER_BINDING);
    program = integer(GL_CURRENT_PROGRAM);
    arrayBuffer = integer(GL_ARRAY_BUFFER_BINDING);
    elementBuffer = integer(GL_ELEMENT_ARRAY_BUFFER_BINDING);
    packBuffer = integer(GL_PIXEL_PACK_BUFFER_BINDING);
    unpackBuffer = integer(GL_PIXEL_UNPACK_BUFFER_BINDING);
    if (gl().bindVertexArray) vertexArray = integer(GL_VERTEX_ARRAY_BINDING);
}

void SavedState::restoreBindings() {
    const GlFunctions& f = gl();
    f.bindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(drawFramebuffer));
    f.bindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(readFramebuffer));
    f.bindRenderbuffer(GL_RENDERBUFFER, static_cast<GLuint>(renderbuffer));
    f.useProgram(static_cast<GLuint>(program));
    if (f.bindVertexArray) f.bindVertexArray(static_cast<GLuint>(vertexArray));
    f.bindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(arrayBuffer));
    f.bindBuffer(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLuint>(elementBuffer));
    f.bindBuffer(GL_PIXEL_PACK_BUFFER, static_cast<GLuint>(packBuffer));
    f.bindBuffer(GL_PIXEL_UNPACK_BUFFER, static_cast<GLuint>(unpackBuffer));
}

}  // namespace radlab
