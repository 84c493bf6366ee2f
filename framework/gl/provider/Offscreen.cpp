// Part of every provider of OpenGL, which defines offscreenKind() and makeOffscreen().

#include <cstdlib>

#include "base/Error.h"
#include "gl/Context.h"

namespace radlab {

std::unique_ptr<GlContext> GlContext::offscreen() {
    const char* wanted = std::getenv("RADLAB_GL");
    if (wanted && *wanted && offscreenKind() != wanted)
        throw Error("RADLAB_GL: found '" + std::string(wanted) + "', expected " + offscreenKind() +
                    ", which is what this program was built with");
    std::unique_ptr<GlContext> context = makeOffscreen();
    context->makeCurrent();
    return context;
}

}  // namespace radlab
