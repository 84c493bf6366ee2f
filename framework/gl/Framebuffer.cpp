#include "gl/Framebuffer.h"

#include <string>

#include "base/Error.h"
#include "gl/Context.h"
#include "gl/SavedState.h"

namespace radlab {

namespace {

GLuint attach(GLenum attachment, GLenum format, int width, int height) {
    GLuint buffer = 0;
    gl().genRenderbuffers(1, &buffer);
    gl().bindRenderbuffer(GL_RENDERBUFFER, buffer);
    gl().renderbufferStorage(GL_RENDERBUFFER, format, width, height);
    gl().framebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
    return buffer;
}

}  // namespace

Framebuffer::Framebuffer(int width, int height, Color kind) : columns(width), rows(height) {
    const SavedState saved;
    GLint largest = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    if (width < 1 || height < 1 || width > largest || height > largest)
        throw Error("picture size: found " + std::to_string(width) + " x " + std::to_string(height) +
                    ", expected 1 to " + std::to_string(largest) + " each way on this OpenGL");
    gl().genFramebuffers(1, &framebuffer);
    gl().bindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    color = attach(GL_COLOR_ATTACHMENT0, kind == Color::bytes ? GL_RGBA8 : GL_RGBA32F, width, height);
    depth = attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, width, height);
    const GLenum status = gl().checkFramebufferStatus(GL_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        throw Error("this OpenGL refuses a framebuffer of " + std::to_string(width) + " x " + std::to_string(height) +
                    " (status " + std::to_string(status) + ")");
}

Framebuffer::~Framebuffer() {
    gl().deleteFramebuffers(1, &framebuffer);
    gl().deleteRenderbuffers(1, &color);
    gl().deleteRenderbuffers(1, &depth);
}

void Framebuffer::bind() const { gl().bindFramebuffer(GL_FRAMEBUFFER, framebuffer); }

}  // namespace radlab
