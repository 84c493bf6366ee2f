// Part of every provider of OpenGL: takes the first of its kinds that works.

#include <cstdlib>

#include "base/Error.h"
#include "gl/Context.h"

namespace radlab {

std::unique_ptr<GlContext> GlContext::offscreen() {
    if (const char* wanted = std::getenv("RADLAB_GL"); wanted && *wanted) return offscreen(wanted);
    std::string reasons;
    for (const std::string& kind : offscreenKinds()) {
        try {
            return offscreen(kind);
        } catch (const Error& error) {
            reasons += std::string("; ") + error.what();
        }
    }
    throw Error("no OpenGL context without a display works here" + reasons);
}

}  // namespace radlab
