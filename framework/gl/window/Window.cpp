#include "gl/window/Window.h"

#include <cstdlib>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

#include "base/Error.h"

namespace radlab {

namespace {

int openWindows = 0;

[[noreturn]] void fail(const std::string& what) {
    const char* reason = nullptr;
    glfwGetError(&reason);
    throw Error("GLFW: " + what + (reason ? std::string(": ") + reason : ""));
}

}  // namespace

Window::Window(int width, int height, const std::string& title, bool visible) {
#if defined(GLFW_PLATFORM_X11) && defined(__linux__)
    // GLFW 3.4 tries Wayland first, whose library prints an error where there is none.
    if (!std::getenv("WAYLAND_DISPLAY")) glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
    if (openWindows == 0 && !glfwInit()) fail("no display");
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_VISIBLE, visible ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 2);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
    window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
    if (!window) {
        if (openWindows == 0) glfwTerminate();
        fail("no window could be opened");
    }
    ++openWindows;
}

Window::~Window() {
    glfwDestroyWindow(window);
    if (--openWindows > 0) return;
#ifdef __SANITIZE_ADDRESS__
    __lsan_do_leak_check();  // GLFW unloads the driver now, and then no suppression can name whose the leaks are
#endif
    glfwTerminate();
}

void Window::bind() { glfwMakeContextCurrent(window); }

void* Window::address(const char* function) const { return reinterpret_cast<void*>(glfwGetProcAddress(function)); }

std::string GlContext::offscreenKind() { return "window"; }

std::unique_ptr<GlContext> GlContext::makeOffscreen() { return std::make_unique<Window>(64, 64, "radlab", false); }

}  // namespace radlab
