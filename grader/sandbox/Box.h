#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "grader/sandbox/Sandbox.h"
#include "grader/sandbox/SystemCalls.h"

namespace radlab::grader {

/// What a program finds in its box: the system's libraries, what is named here, and nothing else.
struct Box {
    explicit Box(Sandbox with) : sandbox(std::move(with)) {}

    /// A folder or file of this machine, and its name in the box.
    struct Shown {
        std::filesystem::path here, there;
    };

    /// Shows a file or folder read-only, and says under which name the program finds it: `there`, or where there
    /// are no namespaces, its own.
    ///
    /// @pre `here` can be read by all, as `readableByAll` makes sure
    std::filesystem::path show(const std::filesystem::path& here, const std::filesystem::path& there);

    Sandbox sandbox;
    Calls calls = Calls::compiler;
    std::vector<Shown> readOnly;
    std::size_t scratch = 0;                    ///< bytes of /tmp; 0: nothing anywhere can be written
    bool programs = false;                      ///< the system's programs and headers, too
    bool processFiles = false;                  ///< /proc, which the sanitizers read
    std::size_t processes = 64;                 ///< threads included
    std::size_t memory = std::size_t{4} << 30;  ///< bytes, all processes and /tmp together
};

/// The file or folder, or a copy of it that lasts as long as this process, which any user of the machine may read: a program
/// in a box is nobody's.
///
/// @param sandbox  where it has no own user, nothing needs to be copied
/// Errors: MachineError.
std::filesystem::path readableByAll(const std::filesystem::path& path, const Sandbox& sandbox);

/// What bubblewrap is called with, up to its "--".
///
/// @param filter  a descriptor that holds the filter of system calls, or -1
std::vector<std::string> bubblewrapArguments(const Box& box, int filter);

}  // namespace radlab::grader
