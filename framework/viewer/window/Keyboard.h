#pragma once

#include <optional>
#include <vector>

#include "viewer/Commands.h"

struct GLFWwindow;

namespace radlab {

/// The commands that the keys of a window ask for.
class Keyboard {
public:
    /// Becomes the window's user pointer, and the one that hears its keys.
    explicit Keyboard(GLFWwindow* window);
    Keyboard(const Keyboard&) = delete;
    Keyboard& operator=(const Keyboard&) = delete;

    /// What was asked for since the last call, in its order.
    std::vector<Command> take();

private:
    static void onKey(GLFWwindow* window, int key, int scancode, int action, int modifiers);
    static void onCharacter(GLFWwindow* window, unsigned int character);
    void add(std::optional<Command> command);

    std::vector<Command> commands;
    bool repeating = false;
};

}  // namespace radlab
