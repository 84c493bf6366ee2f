#include "grader/sandbox/ServeForks.h"

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstring>

namespace radlab::grader {

namespace {

constexpr int judge = 3;  // the socket, where a run has its answer

struct Request {
    std::array<int, 3> ends{};
    bool ownProcesses = false;  // all that can be killed from here was started from here
    std::array<char, 1 << 16> filter{};
    std::size_t filterBytes = 0;
};

bool receive(Request& request) {
    char own = 0;
    std::array<iovec, 2> parts = {{{&own, 1}, {request.filter.data(), request.filter.size()}}};
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof request.ends)> control{};
    msghdr message = {};
    message.msg_iov = parts.data();
    message.msg_iovlen = parts.size();
    message.msg_control = control.data();
    message.msg_controllen = control.size();
    const ssize_t got = recvmsg(judge, &message, 0);
    const cmsghdr* header = CMSG_FIRSTHDR(&message);
    if (got < 1 || !header || header->cmsg_len != CMSG_LEN(sizeof request.ends)) return false;
    std::memcpy(request.ends.data(), CMSG_DATA(header), sizeof request.ends);
    request.ownProcesses = own != 0;
    request.filterBytes = static_cast<std::size_t>(got) - 1;
    return true;
}

bool narrow(Request& request) {
    if (request.filterBytes == 0) return true;
    sock_fprog program = {static_cast<unsigned short>(request.filterBytes / sizeof(sock_filter)),
                          reinterpret_cast<sock_filter*>(request.filter.data())};
    return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

[[noreturn]] void become(Request& request, const std::function<void()>& work) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    prctl(PR_SET_DUMPABLE, 1);
    signal(SIGXFSZ, SIG_IGN);  // what writes a file where it could be opened is told so, and goes on
    for (int i = 0; i < 3; ++i) dup2(request.ends[i == 0 ? 0 : 1], i);
    dup2(request.ends[2], judge);
    close_range(judge + 1, ~0u, 0);
    if (narrow(request)) work();
    _exit(127);
}

}  // namespace

void serveForks(const std::function<void()>& work) {
    prctl(PR_SET_DUMPABLE, 0);  // what is forked from here is of the same user, and may not look in
    const char greeting = 1;
    if (send(judge, &greeting, 1, MSG_NOSIGNAL) != 1) return;
    for (Request request; receive(request);) {
        const pid_t child = fork();
        if (child == 0) become(request, work);
        for (const int end : request.ends) close(end);
        int status = 0;
        if (child < 0 || waitpid(child, &status, 0) != child) return;
        kill(request.ownProcesses ? -1 : -child, SIGKILL);
        while (waitpid(-1, nullptr, WNOHANG) > 0) {
        }
        if (send(judge, &status, sizeof status, MSG_NOSIGNAL) != sizeof status) return;
    }
}

}  // namespace radlab::grader
