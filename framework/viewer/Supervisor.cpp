#include "viewer/Supervisor.h"

#ifndef _WIN32
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <cerrno>
#include <csignal>
#include <cstring>
#endif

#include <iostream>
#include <memory>
#include <new>

#include "base/Error.h"
#include "base/NumberText.h"
#include "base/ProcessTime.h"

namespace radlab {

std::string crashMessage(Running function, const std::string& how) {
    if (function == Running::loading)
        return "Your file " + how +
               " while it was being loaded.\nLook at its global variables: their initialisers run first. "
               "Save the file to load it again.";
    const int stage = stageOf(function);
    return std::string(nameOf(function)) + " " + how +
           ".\nThe viewer has started again on the same scene and view, paused. "
           "Mend stage " +
           std::to_string(stage) + " and save the file, or press space to go on.";
}

#ifdef _WIN32

int supervise(double, const std::function<int(SharedView&, const Restart&)>& viewer) {
    SharedView shared;
    return viewer(shared, {});
}

#else

namespace {

constexpr useconds_t pollTime = 20000;
constexpr double waitingCounts = 0.01;  // of it: behind the limit of its own time, one that no machine should reach

volatile std::sig_atomic_t childToEnd = 0;

void endChild(int signal) {
    if (childToEnd > 0) kill(static_cast<pid_t>(childToEnd), signal);
}

// Memory that parent and children share.
class SharedMemory {
public:
    SharedMemory()
        : place(mmap(nullptr, sizeof(SharedView), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
        if (place == MAP_FAILED) throw Error(std::string("no memory to share: ") + std::strerror(errno));
        view = new (place) SharedView;
    }
    ~SharedMemory() { munmap(place, sizeof(SharedView)); }
    SharedMemory(const SharedMemory&) = delete;
    SharedMemory& operator=(const SharedMemory&) = delete;
    SharedView& operator*() const { return *view; }
    SharedView* operator->() const { return view; }

private:
    void* place;
    SharedView* view;
};

pid_t started(SharedView& shared, const Restart& restart,
              const std::function<int(SharedView&, const Restart&)>& viewer) {
    const pid_t parent = getpid();
    const pid_t child = fork();
    if (child < 0) throw Error(std::string("the viewer cannot be started: ") + std::strerror(errno));
    if (child > 0) return child;
    std::signal(SIGTERM, SIG_DFL);
    std::signal(SIGINT, SIG_DFL);
#ifdef __linux__
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent) _exit(3);
#endif
    std::exit(viewer(shared, restart));  // with its leak check, where there is one
}

struct ViewerEnd {
    int status = 0;
    Running hung = Running::none;
};

// What was crashing, or ending, when it was killed still says so by its status.
ViewerEnd watched(pid_t child, SharedView& shared, double hangSeconds) {
    ViewerEnd ended;
    ProcessTime time(static_cast<int>(child));
    RunningTime functions;
    for (;;) {
        const pid_t got = waitpid(child, &ended.status, WNOHANG);
        if (got == child || (got < 0 && errno != EINTR)) break;
        time.look();
        functions.look(shared.running, time.used() + waitingCounts * time.waited());
        if (ended.hung == Running::none) {
            ended.hung = functions.longerThan(hangSeconds);
            if (ended.hung != Running::none) kill(child, SIGKILL);
        }
        usleep(pollTime);
    }
    if (!WIFSIGNALED(ended.status) || WTERMSIG(ended.status) != SIGKILL) ended.hung = Running::none;
    return ended;
}

std::string howOf(const ViewerEnd& ended, double hangSeconds) {
    if (ended.hung != Running::none) {
        std::string text = "ran for more than ";
        appendNumber(text, hangSeconds, 4);
        return text + " s without an end";
    }
    if (WIFSIGNALED(ended.status)) return std::string("crashed (") + strsignal(WTERMSIG(ended.status)) + ")";
#ifdef __SANITIZE_ADDRESS__
    return "crashed (the sanitizer's report is in the terminal)";
#else
    return "ended the program (exit code " + std::to_string(WEXITSTATUS(ended.status)) + ")";
#endif
}

bool askedToEnd(int status) {
    return WIFSIGNALED(status) &&
           (WTERMSIG(status) == SIGINT || WTERMSIG(status) == SIGTERM || WTERMSIG(status) == SIGHUP);
}

}  // namespace

int supervise(double hangSeconds, const std::function<int(SharedView&, const Restart&)>& viewer) {
    const SharedMemory shared;
    std::signal(SIGTERM, endChild);
    std::signal(SIGINT, endChild);
    Restart restart;
    for (;;) {
        shared->running.depth = 0;
        const pid_t child = started(*shared, restart, viewer);
        childToEnd = static_cast<std::sig_atomic_t>(child);
        const ViewerEnd ended = watched(child, *shared, hangSeconds);
        childToEnd = 0;
        if (askedToEnd(ended.status)) return 128 + WTERMSIG(ended.status);
        const Running at = ended.hung == Running::none ? shared->running.running() : ended.hung;
        if (at == Running::none) {
            if (WIFEXITED(ended.status)) return WEXITSTATUS(ended.status);
            std::cerr << "internal error: the viewer " << howOf(ended, hangSeconds) << '\n';
            return 3;
        }
        restart = {crashMessage(at, howOf(ended, hangSeconds)), at == Running::loading};
        std::cerr << "view: " << restart.message << '\n';
    }
}

#endif

}  // namespace radlab
