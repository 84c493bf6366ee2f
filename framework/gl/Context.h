#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gl/Functions.h"

namespace radlab {

/// An OpenGL context in which everything is drawn: OSMesa, EGL without a surface, or a GLFW window.
///
/// A program links one provider (gl/headless or gl/window), which says what offscreen() makes.
class GlContext {
public:
    /// A context without a display, made current.
    ///
    /// Headless programs take OSMesa, or EGL where OSMesa is absent or the environment says RADLAB_GL=egl;
    /// programs with a window take a hidden window.
    /// Errors: an unknown RADLAB_GL, or none that works here, with what each one said.
    static std::unique_ptr<GlContext> offscreen();

    /// The names that RADLAB_GL takes in this program.
    static std::vector<std::string> offscreenKinds();

    /// The context of that name, made current.
    static std::unique_ptr<GlContext> offscreen(const std::string& kind);

    /// The context that this thread draws in.
    ///
    /// Errors: none is current.
    static GlContext& current();

    virtual ~GlContext();
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

    void makeCurrent();

    const GlFunctions& functions() const { return loaded; }

    /// "OSMesa", "EGL" or "GLFW".
    virtual std::string kind() const = 0;

    /// Its kind, version and renderer in a line, as OpenGL names them.
    ///
    /// @pre it is current
    std::string description() const;

protected:
    GlContext() = default;

private:
    virtual void bind() = 0;
    virtual void* address(const char* function) const = 0;
    void load();

    GlFunctions loaded{};
    bool isLoaded = false;
};

/// The functions of the current context.
inline const GlFunctions& gl() { return GlContext::current().functions(); }

}  // namespace radlab
