#pragma once

#include <filesystem>
#include <string>

#include "viewer/window/Ui.h"

namespace radlab {

/// Writes what the viewer shows as JSON into a file, whole, whenever it has changed: for tests and demonstrations that drive it.
///
///     {"mode", "shots", "playing", "building", "reloads", "scene", "picked", "sum", "banners": [{"title", "text"}], "gl_errors",
///      "help", "settled", "mouse": [x, y], "mouse_down", "fps", "picture": [left, top, right, bottom], "buttons": {name: [left, top, right, bottom]}, "state": {…}}
///
/// Places are in window units from the top left; "state" is what toJson(ViewState) writes.
class Trace {
public:
    /// @param file where to write; empty: nowhere
    explicit Trace(std::filesystem::path file) : target(std::move(file)) {}

    /// @param settled whether all that the user did so far is in it
    void write(Ui& ui, const ImVec4& picture, int glErrors, bool settled);

private:
    const std::filesystem::path target;
    std::string before;
    Stopwatch sinceWrite;
    bool first = true;
};

}  // namespace radlab
