#pragma once

#include "gl/OpenGL.h"

#ifndef APIENTRY
#define APIENTRY
#endif

namespace radlab {

/// The OpenGL functions beyond 1.1 that radlab calls; looked up by name, since not every platform links them.
struct GlFunctions {
    void(APIENTRY* genFramebuffers)(GLsizei, GLuint*);
    void(APIENTRY* deleteFramebuffers)(GLsizei, const GLuint*);
    void(APIENTRY* bindFramebuffer)(GLenum, GLuint);
    GLenum(APIENTRY* checkFramebufferStatus)(GLenum);
    void(APIENTRY* framebufferRenderbuffer)(GLenum, GLenum, GLenum, GLuint);
    void(APIENTRY* genRenderbuffers)(GLsizei, GLuint*);
    void(APIENTRY* deleteRenderbuffers)(GLsizei, const GLuint*);
    void(APIENTRY* bindRenderbuffer)(GLenum, GLuint);
    void(APIENTRY* renderbufferStorage)(GLenum, GLenum, GLsizei, GLsizei);
    void(APIENTRY* bindBuffer)(GLenum, GLuint);
    void(APIENTRY* useProgram)(GLuint);

    // Null where the context does not have them.
    void(APIENTRY* bindVertexArray)(GLuint);
    void(APIENTRY* clampColor)(GLenum, GLenum);
};

}  // namespace radlab
