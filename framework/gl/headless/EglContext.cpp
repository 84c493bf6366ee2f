#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "base/Error.h"
#include "gl/Context.h"

namespace radlab {

namespace {

[[noreturn]] void fail(const std::string& what) {
    char code[16];
    std::snprintf(code, sizeof code, "0x%04x", static_cast<unsigned>(eglGetError()));
    throw Error("EGL: " + what + " (error " + code + ")");
}

EGLDisplay surfacelessDisplay() {
    const auto getDisplay =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (!getDisplay) fail("no displays by platform");
    const EGLDisplay display = getDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY) fail("no surfaceless display");
    if (!eglInitialize(display, nullptr, nullptr)) fail("the surfaceless display does not start");
    return display;
}

// Mesa shares one display over all contexts of the process, so it is started once and left open.
EGLDisplay sharedDisplay() {
    static const EGLDisplay display = surfacelessDisplay();
    return display;
}

class EglContext : public GlContext {
public:
    EglContext() : display(sharedDisplay()) {
        const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        if (!eglBindAPI(EGL_OPENGL_API)) fail("no OpenGL");
        if (!eglChooseConfig(display, wanted, &config, 1, &count) || count == 0) fail("no configuration with OpenGL");
        context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
        if (context == EGL_NO_CONTEXT) fail("no context could be made");
    }
    ~EglContext() override {
        if (eglGetCurrentContext() == context) eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglDestroyContext(display, context);
    }

    std::string kind() const override { return "EGL"; }

private:
    void bind() override {
        if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
            fail("the context could not be made current");
    }
    void* address(const char* function) const override { return reinterpret_cast<void*>(eglGetProcAddress(function)); }

    EGLDisplay display;
    EGLContext context = EGL_NO_CONTEXT;
};

}  // namespace

std::string GlContext::offscreenKind() { return "egl"; }

std::unique_ptr<GlContext> GlContext::makeOffscreen() { return std::make_unique<EglContext>(); }

}  // namespace radlab
