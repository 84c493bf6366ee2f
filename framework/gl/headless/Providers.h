#pragma once

#include "gl/Context.h"

namespace radlab {

#ifdef RADLAB_HAVE_OSMESA
std::unique_ptr<GlContext> makeOsMesaContext();
#endif
#ifdef RADLAB_HAVE_EGL
std::unique_ptr<GlContext> makeEglContext();
#endif

}  // namespace radlab
