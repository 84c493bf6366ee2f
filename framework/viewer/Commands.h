#pragma once

#include <optional>
#include <vector>

namespace radlab {

/// What a key or button does.
enum class Command {
    playPause,
    oneShot,
    reset,
    wireframe,
    flat,
    smooth,
    unshot,
    ids,
    formFactors,
    meshLines,
    orbitLeft,
    orbitRight,
    orbitUp,
    orbitDown,
    zoomIn,
    zoomOut,
    frameAll,
    firstView,
    brighter,
    darker,
    autoExposure,
    unpick,
    panel,
    screenshot,
    help,
    quit,
};

/// Keys that are no characters.
enum class Key { none, escape, f1, left, right, up, down };

/// One way to give a command.
struct Binding {
    Command command;
    char character;    ///< that is typed; 0 for none
    Key key;           ///< or the key
    const char* keys;  ///< both, for the help
    const char* what;  ///< it does, for the help
};

/// All keys: what dispatches them is what the help shows.
const std::vector<Binding>& bindings();

/// What a typed character means, upper or lower case.
std::optional<Command> commandOf(char character);
std::optional<Command> commandOf(Key key);

/// Whether holding the key down gives the command again and again.
bool repeats(Command command);

}  // namespace radlab
