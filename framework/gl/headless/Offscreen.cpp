#include "base/Error.h"
#include "gl/headless/Providers.h"

namespace radlab {

std::vector<std::string> GlContext::offscreenKinds() {
    return {
#ifdef RADLAB_HAVE_OSMESA
        "osmesa",
#endif
#ifdef RADLAB_HAVE_EGL
        "egl",
#endif
    };
}

std::unique_ptr<GlContext> GlContext::offscreen(const std::string& kind) {
    std::unique_ptr<GlContext> context;
#ifdef RADLAB_HAVE_OSMESA
    if (kind == "osmesa") context = makeOsMesaContext();
#endif
#ifdef RADLAB_HAVE_EGL
    if (kind == "egl") context = makeEglContext();
#endif
    if (!context) {
        std::string kinds;
        for (const std::string& known : offscreenKinds()) kinds += (kinds.empty() ? "" : " or ") + known;
        throw Error("RADLAB_GL: unknown kind of OpenGL context, found '" + kind + "', expected " + kinds);
    }
    context->makeCurrent();
    return context;
}

}  // namespace radlab
