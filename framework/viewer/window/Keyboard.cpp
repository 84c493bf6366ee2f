#include "viewer/window/Keyboard.h"

#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace radlab {

namespace {

Key keyOf(int key) {
    switch (key) {
        case GLFW_KEY_ESCAPE: return Key::escape;
        case GLFW_KEY_F1: return Key::f1;
        case GLFW_KEY_LEFT: return Key::left;
        case GLFW_KEY_RIGHT: return Key::right;
        case GLFW_KEY_UP: return Key::up;
        case GLFW_KEY_DOWN: return Key::down;
        default: return Key::none;
    }
}

Keyboard& keyboardOf(GLFWwindow* window) { return *static_cast<Keyboard*>(glfwGetWindowUserPointer(window)); }

}  // namespace

Keyboard::Keyboard(GLFWwindow* window) {
    glfwSetWindowUserPointer(window, this);
    glfwSetKeyCallback(window, onKey);
    glfwSetCharCallback(window, onCharacter);
}

void Keyboard::onKey(GLFWwindow* window, int key, int, int action, int) {
    if (action == GLFW_RELEASE) return;
    keyboardOf(window).repeating = action == GLFW_REPEAT;
    keyboardOf(window).add(commandOf(keyOf(key)));
}

void Keyboard::onCharacter(GLFWwindow* window, unsigned int character) {
    if (character < 128) keyboardOf(window).add(commandOf(static_cast<char>(character)));
}

void Keyboard::add(std::optional<Command> command) {
    if (command && (!repeating || repeats(*command))) commands.push_back(*command);
}

std::vector<Command> Keyboard::take() { return std::exchange(commands, {}); }

}  // namespace radlab
