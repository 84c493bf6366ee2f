#pragma once

#include <string>

namespace radlab::grader {

/// Whom a filter of system calls is for; each allows what the one before does, and more.
enum class Calls {
    submission,  ///< reading files, memory, threads; no processes, no programs, nothing that changes a file
    server,      ///< also forks, starts its first program and talks over the sockets that it was given
    compiler,    ///< also starts programs, and makes and removes files
};

/// The filter as the kernel takes it (an array of sock_filter), for this kind of processor.
///
/// What it does not name fails as if the kernel had no such call: sockets, ptrace, keys, io_uring, mounts, bpf,
/// userfaultfd, namespaces, and whatever a newer kernel brings. Of ioctl, only reading a terminal's kind remains. Another
/// processor's calls (32 bits) kill the process.
/// @return empty where this build has no libseccomp
/// Errors: MachineError.
const std::string& filterProgram(Calls calls);

}  // namespace radlab::grader
