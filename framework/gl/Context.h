#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gl/Functions.h"

namespace radlab {

/// An OpenGL context in which everything is drawn: OSMesa, EGL without a surface, or a GLFW window.
///
/// A program links one provider (a file of gl/headless, or gl/window), which says what offscreen() makes.
class GlContext {
public:
    /// A context without a display, made current.
    ///
    /// Programs without a window draw with EGL, or with OSMesa where the build found no EGL; programs with one, in a hidden window.
    /// Errors: it does not work here; the environment's RADLAB_GL asks for another.
    static std::unique_ptr<GlContext> offscreen();

    /// What offscreen() makes in this program, as RADLAB_GL names it: "egl", "osmesa" or "window".
    static std::string offscreenKind();

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
    static std::unique_ptr<GlContext> makeOffscreen();
    virtual void bind() = 0;
    virtual void* address(const char* function) const = 0;
    void load();

    GlFunctions loaded{};
    bool isLoaded = false;
};

/// The functions of the current context.
inline const GlFunctions& gl() { return GlContext::current().functions(); }

}  // namespace radlab
