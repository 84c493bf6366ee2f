#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace radlab::grader {

/// Where this process may make control groups; empty where it may not.
struct ControlGroupPlaces {
    std::filesystem::path pids, memory;  ///< the same folder with version 2
    bool unified = false;                ///< version 2

    bool any() const { return !pids.empty() || !memory.empty(); }
};

/// Looks for them: version 2, and else version 1.
///
/// @param root  where the files of the kernel are, "/" but in tests
ControlGroupPlaces findControlGroupPlaces(const std::filesystem::path& root = "/");

/// A control group of its own, which caps processes and memory of all that join it, and goes with them.
class ControlGroup {
public:
    /// @param bytes  of memory, files in memory included; there is no swap beyond them
    /// Errors: MachineError.
    ControlGroup(const ControlGroupPlaces& places, std::size_t processes, std::size_t bytes);
    ~ControlGroup();
    ControlGroup(const ControlGroup&) = delete;
    ControlGroup& operator=(const ControlGroup&) = delete;

    /// A process joins by writing "0" into each of these.
    const std::vector<std::string>& joinFiles() const { return joins; }

private:
    void makeFolder(const std::filesystem::path& place);

    std::vector<std::filesystem::path> folders;
    std::vector<std::string> joins;
};

}  // namespace radlab::grader
