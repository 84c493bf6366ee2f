#pragma once

#include <functional>

#include <CLI/CLI.hpp>

#include "base/Program.h"

namespace radlab {

/// Reads a program's flags and runs its body; adds --version where the program has none of its own.
///
/// @return 2 for wrong flags, with the reason on stderr; 0 where help or the version was asked for; else as runProgram
inline int runCommandLine(CLI::App& app, int argc, char** argv, const std::function<int()>& body) {
    if (!app.get_version_ptr()) app.set_version_flag("--version", "radlab " RADLAB_VERSION);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    return runProgram(body);
}

}  // namespace radlab
