#pragma once

#include <functional>
#include <string>

#include "viewer/Running.h"
#include "viewer/ViewState.h"

namespace radlab {

/// What the viewer leaves where its supervisor, and the viewer that is started after it, can read it.
struct SharedView {
    RunningNow running;
    ViewState state;
    char loaded[64] = "";   ///< stamp of the source whose functions are in use
    char scene[4096] = "";  ///< the file that is shown; empty before the first
    char copy[4096] = "";   ///< the library that is being loaded; a crash leaves it behind
};

/// Why a viewer was started anew; all empty for the first.
struct Restart {
    std::string message;         ///< what happened to the last one, naming the function
    bool inInitialiser = false;  ///< it happened while the library was being loaded
};

/// Runs the viewer in a process of its own, and again where it ends while a student's function is running.
///
/// A function that crashes, ends the program or runs for longer than `hangSeconds` of its own time (see ProcessTime) ends only that
/// process; the next one gets the state that the last one left, and a message. What goes wrong outside of student's functions is not tried again. Where there are no
/// processes to fork (Windows), the viewer runs in this one.
///
/// @param viewer what the process does, and its exit code
/// @return the exit code; 3 where the viewer itself crashed
int supervise(double hangSeconds, const std::function<int(SharedView&, const Restart&)>& viewer);

/// What to tell of a function at which a viewer ended.
///
/// @param how "crashed (segmentation fault)"
std::string crashMessage(Running function, const std::string& how);

}  // namespace radlab
