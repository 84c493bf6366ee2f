#include <array>

#include <GL/osmesa.h>

#include "base/Error.h"
#include "gl/Context.h"

namespace radlab {

namespace {

// Its own colour buffer is 1 x 1: everything is drawn into framebuffer objects.
class OsMesaContext : public GlContext {
public:
    OsMesaContext() : context(OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr)) {
        if (!context) throw Error("OSMesa: no context could be made");
    }
    ~OsMesaContext() override {
        // Destroying the current one crashes where it still has something to draw.
        if (OSMesaGetCurrentContext() == context) OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
        OSMesaDestroyContext(context);
    }

    std::string kind() const override { return "OSMesa"; }

private:
    void bind() override {
        if (!OSMesaMakeCurrent(context, pixel.data(), GL_UNSIGNED_BYTE, 1, 1))
            throw Error("OSMesa: the context could not be made current");
    }
    void* address(const char* function) const override {
        return reinterpret_cast<void*>(OSMesaGetProcAddress(function));
    }

    OSMesaContext context;
    std::array<GLubyte, 4> pixel{};
};

}  // namespace

std::string GlContext::offscreenKind() { return "osmesa"; }

std::unique_ptr<GlContext> GlContext::makeOffscreen() { return std::make_unique<OsMesaContext>(); }

}  // namespace radlab
