#include "grader/sandbox/SystemCalls.h"

#if __has_include(<seccomp.h>)

#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <initializer_list>
#include <memory>

#include "grader/sandbox/Pipes.h"
#include "grader/sandbox/Process.h"

namespace radlab::grader {

namespace {

constexpr std::uint64_t newNamespaces =
    CLONE_NEWNS | CLONE_NEWCGROUP | CLONE_NEWUTS | CLONE_NEWIPC | CLONE_NEWUSER | CLONE_NEWPID | CLONE_NEWNET;

using Names = std::initializer_list<const char*>;

constexpr Names ofAll = {
    // files, without changing any
    "read", "readv", "pread64", "preadv", "preadv2", "write", "writev", "pwrite64", "pwritev", "close", "close_range",
    "lseek", "stat", "lstat", "fstat", "newfstatat", "statx", "statfs", "fstatfs", "access", "faccessat", "faccessat2",
    "readlink", "readlinkat", "getcwd", "getdents64", "fcntl", "dup", "dup2", "dup3", "fadvise64", "pipe", "pipe2",
    "poll", "ppoll", "select", "pselect6", "eventfd2",
    // memory
    "mmap", "munmap", "mprotect", "mremap", "madvise", "brk", "mincore", "msync",
    // threads, signals and time
    "futex", "set_robust_list", "get_robust_list", "rseq", "set_tid_address", "membarrier", "sched_yield",
    "sched_getaffinity", "sched_setaffinity", "sched_getparam", "sched_getscheduler", "sched_get_priority_max",
    "sched_get_priority_min", "getcpu", "rt_sigaction", "rt_sigprocmask", "rt_sigreturn", "rt_sigpending",
    "rt_sigtimedwait", "rt_sigsuspend", "sigaltstack", "tgkill", "restart_syscall", "pause", "nanosleep",
    "clock_nanosleep", "clock_gettime", "clock_getres", "gettimeofday", "time", "times", "alarm", "setitimer",
    "getitimer",
    // about itself
    "getpid", "gettid", "getppid", "getpgrp", "getpgid", "getsid", "getuid", "geteuid", "getgid", "getegid",
    "getresuid", "getresgid", "getgroups", "uname", "sysinfo", "getrlimit", "getrusage", "arch_prctl", "prctl",
    "getrandom", "exit", "exit_group"};

// Flags of open that let a file be made or changed.
constexpr std::uint64_t changing = O_ACCMODE | O_CREAT | O_TRUNC;

constexpr Names ofServers = {"open",   "openat",  "fork",    "vfork",   "wait4",     "waitid", "kill",
                             "execve", "sendmsg", "recvmsg", "setpgid", "setrlimit", "sendto", "recvfrom"};

constexpr Names ofCompilers = {"unlink",   "unlinkat", "rename",    "renameat",        "renameat2", "chmod", "fchmod",
                               "fchmodat", "umask",    "ftruncate", "fallocate",       "utimensat", "utime", "chdir",
                               "fsync",    "mkdir",    "execveat",  "copy_file_range", "sendfile"};

class Filter {
public:
    // Else a call would go through, or its process be killed, where the kernel is newer than this list.
    Filter() : context(seccomp_init(SCMP_ACT_ERRNO(ENOSYS)), seccomp_release) {
        if (!context) throw MachineError("no filter of system calls could be made");
    }

    void allow(const Names& names) {
        for (const char* name : names) allowWhere(name, {});
    }

    // A name that this kind of processor does not have is passed over.
    void allowWhere(const char* name, std::initializer_list<scmp_arg_cmp> conditions) {
        const int number = seccomp_syscall_resolve_name(name);
        if (number < 0) return;
        const int failure = seccomp_rule_add_array(context.get(), SCMP_ACT_ALLOW, number,
                                                   static_cast<unsigned>(conditions.size()), conditions.begin());
        if (failure != 0) throw MachineError(std::string("no filter of system calls could be made: ") + name);
    }

    std::string program() const {
        const Descriptor file = memoryFile("");
        if (seccomp_export_bpf(context.get(), file.get()) != 0 || lseek(file.get(), 0, SEEK_SET) != 0)
            throw MachineError("the filter of system calls could not be written");
        std::string bytes;
        std::array<char, 4096> block;
        for (ssize_t got; (got = read(file.get(), block.data(), block.size())) > 0;)
            bytes.append(block.data(), static_cast<std::size_t>(got));
        return bytes;
    }

private:
    std::unique_ptr<void, decltype(&seccomp_release)> context;
};

std::string makeFilter(Calls calls) {
    Filter filter;
    filter.allow(ofAll);
    filter.allowWhere("ioctl", {SCMP_A1(SCMP_CMP_EQ, TCGETS, 0)});
    filter.allowWhere("ioctl", {SCMP_A1(SCMP_CMP_EQ, FIONREAD, 0)});
    if (calls == Calls::submission) {
        filter.allowWhere("open", {SCMP_A1(SCMP_CMP_MASKED_EQ, changing, O_RDONLY)});
        filter.allowWhere("openat", {SCMP_A2(SCMP_CMP_MASKED_EQ, changing, O_RDONLY)});
        filter.allowWhere("clone", {SCMP_A0(SCMP_CMP_MASKED_EQ, newNamespaces | CLONE_THREAD, CLONE_THREAD)});
        filter.allowWhere("prlimit64", {SCMP_A2(SCMP_CMP_EQ, 0, 0)});  // reads a limit
        return filter.program();
    }
    filter.allow(ofServers);
    filter.allow({"prlimit64"});
    filter.allowWhere("clone", {SCMP_A0(SCMP_CMP_MASKED_EQ, newNamespaces, 0)});
    filter.allowWhere("seccomp", {});  // a server gives what it forks a narrower filter
    if (calls == Calls::compiler) filter.allow(ofCompilers);
    return filter.program();
}

}  // namespace

const std::string& filterProgram(Calls calls) {
    static const std::array<std::string, 3> made = {makeFilter(Calls::submission), makeFilter(Calls::server),
                                                    makeFilter(Calls::compiler)};
    return made[static_cast<std::size_t>(calls)];
}

}  // namespace radlab::grader

#else

namespace radlab::grader {

const std::string& filterProgram(Calls) {
    static const std::string none;
    return none;
}

}  // namespace radlab::grader

#endif
