#include "gl/Context.h"

#include <type_traits>

#include "base/Error.h"

namespace radlab {

namespace {

thread_local GlContext* currentContext = nullptr;

}  // namespace

GlContext& GlContext::current() {
    if (!currentContext) throw Error("no OpenGL context is current: make one with GlContext::offscreen() first");
    return *currentContext;
}

GlContext::~GlContext() {
    if (currentContext == this) currentContext = nullptr;
}

void GlContext::makeCurrent() {
    bind();
    if (!isLoaded) load();
    currentContext = this;
}

std::string GlContext::description() const {
    const auto text = [](GLenum name) { return std::string(reinterpret_cast<const char*>(glGetString(name))); };
    return kind() + ", OpenGL " + text(GL_VERSION) + ", " + text(GL_RENDERER);
}

void GlContext::load() {
    if (!glGetString(GL_VERSION))
        throw Error("the " + kind() + " context does not answer OpenGL calls: another library has taken them over");
    const auto require = [this](auto& pointer, const char* name) {
        using Pointer = std::remove_reference_t<decltype(pointer)>;
        pointer = reinterpret_cast<Pointer>(address(name));
        if (!pointer)
            throw Error("the " + kind() + " context has no " + name + ": found OpenGL " +
                        reinterpret_cast<const char*>(glGetString(GL_VERSION)) +
                        ", expected 2.1 with framebuffer objects");
    };
    require(loaded.genFramebuffers, "glGenFramebuffers");
    require(loaded.deleteFramebuffers, "glDeleteFramebuffers");
    require(loaded.bindFramebuffer, "glBindFramebuffer");
    require(loaded.checkFramebufferStatus, "glCheckFramebufferStatus");
    require(loaded.framebufferRenderbuffer, "glFramebufferRenderbuffer");
    require(loaded.genRenderbuffers, "glGenRenderbuffers");
    require(loaded.deleteRenderbuffers, "glDeleteRenderbuffers");
    require(loaded.bindRenderbuffer, "glBindRenderbuffer");
    require(loaded.renderbufferStorage, "glRenderbufferStorage");
    require(loaded.bindBuffer, "glBindBuffer");
    require(loaded.useProgram, "glUseProgram");
    loaded.bindVertexArray = reinterpret_cast<decltype(loaded.bindVertexArray)>(address("glBindVertexArray"));
    loaded.clampColor = reinterpret_cast<decltype(loaded.clampColor)>(address("glClampColor"));
    isLoaded = true;
}

}  // namespace radlab
