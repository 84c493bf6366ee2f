#pragma once

#include <array>
#include <vector>

#include "gl/OpenGL.h"

namespace radlab {

/// Keeps the whole OpenGL state and puts it back when it goes, whatever was called in between.
///
/// What is undone: every server and client attribute, matrices and their stacks, bound framebuffers,
/// buffers, vertex arrays and program, the render mode, a primitive or display list left open, unbalanced pushes, and
/// up to three attribute pops too many. Contents of objects (textures, lists, buffers) are not state and stay changed.
///
/// @pre  a GlContext is current, and not between glBegin and glEnd
/// @cost some 50 calls, no drawing
class SavedState {
public:
    SavedState();
    ~SavedState();
    SavedState(const SavedState&) = delete;
    SavedState& operator=(const SavedState&) = delete;

    /// Errors: what the code since the saving did that a drawing function must not do (a missing glEnd,
    /// more pops than pushes); the state is put back all the same.
    void checkBalance();

private:
    struct MatrixStack {
        GLenum mode, depthName, matrixName;
        std::vector<std::array<GLdouble, 16>> levels;  // bottom first
    };

    void endWhatIsOpen();
    void readMatrices();
    void restoreMatrices();
    void pushAttributes();
    void restoreAttributes();
    void readBindings();
    void restoreBindings();

    std::array<MatrixStack, 3> stacks;
    GLint matrixMode = 0;
    GLint attributeDepth = 0, clientAttributeDepth = 0;
    GLint drawFramebuffer = 0, readFramebuffer = 0, renderbuffer = 0;
    GLint program = 0, arrayBuffer = 0, elementBuffer = 0, packBuffer = 0, unpackBuffer = 0, vertexArray = 0;
};

}  // namespace radlab
