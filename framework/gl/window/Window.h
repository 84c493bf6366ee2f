#pragma once

#include "gl/Context.h"

struct GLFWwindow;

namespace radlab {

/// A GLFW window with an OpenGL context, shown or hidden.
///
/// Errors: no display to open it on.
class Window : public GlContext {
public:
    Window(int width, int height, const std::string& title, bool visible);
    ~Window() override;

    std::string kind() const override { return "GLFW"; }

    /// The window itself, for GLFW's input functions.
    GLFWwindow* handle() const { return window; }

private:
    void bind() override;
    void* address(const char* function) const override;

    GLFWwindow* window = nullptr;
};

}  // namespace radlab
