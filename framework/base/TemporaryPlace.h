#pragma once

#include <filesystem>

namespace radlab {

/// The folder for short-lived files, libraries and programs among them.
///
/// The system's own ($TMPDIR, or else /tmp); where nothing may be started from there, as on a file system mounted noexec,
/// /var/tmp or /dev/shm. Root takes one that other users may enter, where there is one, as it starts programs for them.
///
/// Errors: none of them will do.
std::filesystem::path temporaryPlace();

}  // namespace radlab
