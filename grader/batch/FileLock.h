#pragma once

#include <filesystem>

#include "grader/sandbox/Pipes.h"

namespace radlab::grader {

/// A file that one process at a time holds; whatever ends that process, the file is free again.
///
/// Not passed on to a process that is forked and closes what it inherits.
class FileLock {
public:
    /// Takes hold of the file, which is made where there is none.
    ///
    /// @param what  holds it, for the message: "another grade command"
    /// Errors: somebody else has it, with that process's id; a folder that cannot be written.
    /// @cost   up to a second where somebody has it; up to a minute where that process is gone, and what it started is not yet
    FileLock(const std::filesystem::path& file, const std::string& what);

private:
    Descriptor held;
};

}  // namespace radlab::grader
