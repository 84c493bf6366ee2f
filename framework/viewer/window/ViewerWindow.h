#pragma once

#include <filesystem>

#include "viewer/Viewer.h"

namespace radlab {

/// How the window of a viewer looks.
struct WindowOptions {
    int width = 1280, height = 800;  ///< in window units
    float scale = 0.0f;              ///< of fonts and controls; 0: the display's
    std::filesystem::path trace;     ///< where to write what is shown; empty: nowhere
    double benchSeconds = 0.0;       ///< 0: no measurement
};

/// Opens the window and shows the viewer until it is closed.
///
/// @return exit code 0
/// Errors: no display; a trace that cannot be written.
int runViewerWindow(const WindowOptions& look, const ViewerOptions& options, SharedView& shared,
                    const Restart& restart);

}  // namespace radlab
