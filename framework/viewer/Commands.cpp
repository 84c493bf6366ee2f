#include "viewer/Commands.h"

#include <cctype>

namespace radlab {

const std::vector<Binding>& bindings() {
    static const std::vector<Binding> all = {
        {Command::playPause, ' ', Key::none, "space", "play or pause"},
        {Command::oneShot, 'n', Key::none, "N", "one shot"},
        {Command::reset, 'r', Key::none, "R", "back to before the first shot"},
        {Command::wireframe, 'w', Key::none, "W", "show the mesh over the reflectances"},
        {Command::flat, 'l', Key::none, "L", "show radiance, flat"},
        {Command::smooth, 'g', Key::none, "G", "show radiance, smooth (Gouraud)"},
        {Command::unshot, 'u', Key::none, "U", "show unshot power"},
        {Command::ids, 'i', Key::none, "I", "show what renderPatchIDs draws"},
        {Command::formFactors, 'o', Key::none, "O", "show form factors of the picked patch"},
        {Command::meshLines, 'm', Key::none, "M", "mesh lines over any picture"},
        {Command::orbitLeft, 0, Key::left, "left", "turn"},
        {Command::orbitRight, 0, Key::right, "right", "turn"},
        {Command::orbitUp, 0, Key::up, "up", "turn"},
        {Command::orbitDown, 0, Key::down, "down", "turn"},
        {Command::zoomIn, '+', Key::none, "+", "nearer"},
        {Command::zoomOut, '-', Key::none, "-", "farther"},
        {Command::frameAll, 'f', Key::none, "F", "frame the whole scene"},
        {Command::firstView, 'v', Key::none, "V", "the scene's own view"},
        {Command::brighter, 'e', Key::none, "E", "brighter by a third of a stop"},
        {Command::darker, 'd', Key::none, "D", "darker by a third of a stop"},
        {Command::autoExposure, 'a', Key::none, "A", "automatic exposure"},
        {Command::unpick, 'x', Key::none, "X", "let go of the picked patch"},
        {Command::panel, 'p', Key::none, "P", "show or hide the panels"},
        {Command::screenshot, 's', Key::none, "S", "screenshot"},
        {Command::help, '?', Key::f1, "?  F1", "these keys"},
        {Command::quit, 0, Key::escape, "esc", "quit"},
    };
    return all;
}

std::optional<Command> commandOf(char character) {
    const auto lower = static_cast<char>(std::tolower(static_cast<unsigned char>(character)));
    for (const Binding& binding : bindings())
        if (binding.character != 0 && binding.character == lower) return binding.command;
    return std::nullopt;
}

std::optional<Command> commandOf(Key key) {
    for (const Binding& binding : bindings())
        if (key != Key::none && binding.key == key) return binding.command;
    return std::nullopt;
}

bool repeats(Command command) {
    switch (command) {
        case Command::oneShot:
        case Command::orbitLeft:
        case Command::orbitRight:
        case Command::orbitUp:
        case Command::orbitDown:
        case Command::zoomIn:
        case Command::zoomOut:
        case Command::brighter:
        case Command::darker: return true;
        default: return false;
    }
}

}  // namespace radlab
