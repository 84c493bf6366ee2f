#include "grader/sandbox/Launch.h"

#include <fcntl.h>
#include <grp.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <csignal>
#include <string>
#include <vector>

#include "grader/sandbox/Pipes.h"

namespace radlab::grader {

namespace {

constexpr int answerDescriptor = 3, filterDescriptor = 4;
constexpr std::size_t mostOpenFiles = 256;
constexpr uid_t firstOwnUser = 0x70000000;  // far from all that a machine gives to people and services

// All that is needed between fork and exec, where nothing may be allocated.
struct Start {
    std::array<int, 4> descriptors{};
    int filter = -1;                 // for bubblewrap, which loads it last
    sock_fprog program{0, nullptr};  // to load at once, where there is no bubblewrap
    std::vector<const char*> groups;
    uid_t user = 0;  // 0: stays who it is
    rlim_t processes = 0;
    const ProcessLimits* limits = nullptr;
    const char* folder = nullptr;
    std::vector<char*> arguments, environment;
};

void limit(int resource, rlim_t value) {
    const rlimit both = {value, value};
    setrlimit(static_cast<__rlimit_resource>(resource), &both);
}

void setLimits(const Start& start) {
    const ProcessLimits& limits = *start.limits;
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, limits.file);
    limit(RLIMIT_NOFILE, mostOpenFiles);
    if (start.processes) limit(RLIMIT_NPROC, start.processes);
    if (limits.memory) limit(RLIMIT_AS, limits.memory);
    // Beyond what the judge allows, so that the judge comes first, whose reckoning of waiting is not to the second.
    if (limits.seconds > 0) limit(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(2.0 * limits.seconds)) + 1);
}

bool joinGroups(const Start& start) {
    for (const char* file : start.groups) {
        const int group = open(file, O_WRONLY);
        const bool joined = group >= 0 && write(group, "0", 1) == 1;
        close(group);
        if (!joined) return false;
    }
    return true;
}

// By the kernel's own calls: those of the library would change the threads of the judge, whose memory this still is.
bool becomeUser(uid_t user) {
    return user == 0 || (syscall(SYS_setgroups, 0, nullptr) == 0 && syscall(SYS_setresgid, user, user, user) == 0 &&
                         syscall(SYS_setresuid, user, user, user) == 0);
}

void placeDescriptors(const Start& start) {
    for (int i = 0; i <= answerDescriptor; ++i) dup2(start.descriptors[static_cast<std::size_t>(i)], i);
    if (start.filter >= 0) dup2(start.filter, filterDescriptor);
    close_range(start.filter >= 0 ? filterDescriptor + 1 : answerDescriptor + 1, ~0u, 0);
}

// Between fork and exec: calls that are safe there, and nothing else.
[[noreturn]] void become(const Start& start) {
    setpgid(0, 0);
    if (joinGroups(start) && becomeUser(start.user)) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
        placeDescriptors(start);
        setLimits(start);
        signal(SIGPIPE, SIG_DFL);
        const bool there = chdir(start.folder) == 0;  // the filter may forbid it
        const bool filtered = start.program.len == 0 || prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &start.program) == 0;
        if (there && filtered) execve(start.arguments[0], start.arguments.data(), start.environment.data());
    }
    _exit(cannotStart);
}

std::vector<char*> pointers(const std::vector<std::string>& texts) {
    std::vector<char*> all;
    for (const std::string& text : texts) all.push_back(const_cast<char*>(text.c_str()));
    all.push_back(nullptr);
    return all;
}

std::vector<std::string> argumentsOf(const Command& command, bool boxed, bool filtered) {
    if (!boxed) return command.arguments;
    std::vector<std::string> all = bubblewrapArguments(*command.box, filtered ? filterDescriptor : -1);
    all.insert(all.end() - 1, {"--chdir", command.folder.string()});
    all.insert(all.end(), command.arguments.begin(), command.arguments.end());
    return all;
}

}  // namespace

uid_t ownUserOfThread() { return firstOwnUser + static_cast<uid_t>(gettid()); }

Launched::Launched(const Command& command, const ProcessLimits& limits, int input, int output, int answer) {
    const Box* box = command.box ? &*command.box : nullptr;
    const bool boxed = box && !box->sandbox.bubblewrap.empty(), filtered = box && box->sandbox.filter;
    const std::vector<std::string> arguments = argumentsOf(command, boxed, filtered);
    std::vector<std::string> environment = command.environment;
    if (access(arguments[0].c_str(), X_OK) != 0) failWithErrno(arguments[0] + ": cannot be started");
    Start start;
    start.descriptors = {input, output, output, answer};
    start.limits = &limits;
    start.folder = boxed ? "/" : command.folder.c_str();
    if (box && box->sandbox.ownUser) {
        start.user = ownUserOfThread();
        start.processes = box->processes;
    }
    if (box && box->scratch && !boxed) {
        scratch.emplace();
        if (start.user && chown(scratch->path().c_str(), start.user, start.user) != 0)
            failWithErrno(scratch->path().string() + ": cannot be given away");
    }
    if (box && box->scratch) environment.push_back("TMPDIR=" + (boxed ? "/tmp" : scratch->path().string()));
    if (box && box->sandbox.groups.any()) {
        group.emplace(box->sandbox.groups, box->processes, box->memory);
        for (const std::string& file : group->joinFiles()) start.groups.push_back(file.c_str());
    }
    Descriptor filterFile;
    if (filtered) {
        const std::string& program = filterProgram(box->calls);
        if (boxed) filterFile = memoryFile(program);
        start.filter = filterFile.get();
        if (!boxed)
            start.program = {static_cast<unsigned short>(program.size() / sizeof(sock_filter)),
                             reinterpret_cast<sock_filter*>(const_cast<char*>(program.data()))};
    }
    start.arguments = pointers(arguments);
    start.environment = pointers(environment);
    number = vfork();  // a copy of the judge's page tables would take longer than many a check
    if (number < 0) failWithErrno("no process could be made");
    if (number == 0) become(start);
    setpgid(number, number);  // in both, so that it holds whichever comes first
}

Launched::~Launched() {
    stop();
    if (!reaped) waitpid(number, nullptr, 0);
}

void Launched::stop() const { kill(-number, SIGKILL); }

bool Launched::hasEnded(Ended& ended) {
    int status = 0;
    if (waitpid(number, &status, WNOHANG) != number) return false;
    reaped = true;
    ended.how = WIFSIGNALED(status) ? Ended::How::signalled : Ended::How::exited;
    ended.code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
    return true;
}

}  // namespace radlab::grader
