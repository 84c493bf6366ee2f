#pragma once

#include <string_view>

#include "grader/intake/Choice.h"

namespace radlab::grader {

/// Looks through a zip or tar archive of a stranger.
///
/// Nothing is unpacked to a disk, and nothing in the archive is followed: only regular files with plain, relative names
/// are taken. An archive that is cut off, corrupt, encrypted or a bomb gives nothing but a remark. Archives in it are
/// not opened. Runs in a process of its own (unpackArchive): a mistake in the library that reads archives stays there.
///
/// @return at most one file for each name of the rules
/// @cost   unpacks a tar twice, once to its end: one that is cut off between two files looks whole to the library
/// @source APPNOTE 6.3 (zip), POSIX pax (tar)
Gathered readArchive(std::string_view bytes, const IntakeRules& rules);

}  // namespace radlab::grader
