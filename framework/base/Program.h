#pragma once

#include <functional>

namespace radlab {

/// Runs the body of a program and turns what it throws into an exit code.
///
/// @return what body returns; 2 with one line on stderr for an Error (bad input) or a stub that is not
///         written yet; 130 where Ctrl-C ended it (Interrupted); 3 for anything else (a fault of the program or machine)
int runProgram(const std::function<int()>& body);

}  // namespace radlab
