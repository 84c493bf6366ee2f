#pragma once

#include <filesystem>

namespace radlab::grader {

/// A folder of its own that goes with everything in it; others may look up names in it, but not list them.
///
/// A process that was forked from the maker leaves it alone. What a process left that was killed goes with the next one
/// made, if it is more than a day old.
class TemporaryFolder {
public:
    /// Errors: MachineError.
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    const std::filesystem::path& path() const { return folder; }

private:
    std::filesystem::path folder;
    int maker;
};

}  // namespace radlab::grader
