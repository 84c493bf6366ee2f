#pragma once

#include <filesystem>

#include "solver/CourseFunctions.h"

namespace radlab {

/// The six functions of a shared library that the build made with LibraryEntry.cc.
///
/// The library stays loaded to the end of the program, since what it threw or made may still be in use.
/// Errors: what the dynamic linker says, as for a function that is declared and nowhere written.
/// @return the library's functions; its initialisers have run
CourseFunctions loadCourseFunctions(const std::filesystem::path& library);

}  // namespace radlab
