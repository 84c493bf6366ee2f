#include "grader/sandbox/Process.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <thread>
#include <utility>

#include "base/ProgressBar.h"
#include "base/Stopwatch.h"
#include "grader/sandbox/ProcessorWait.h"

namespace radlab::grader {

namespace {

constexpr int answerDescriptor = 3;
constexpr int firstFree = 10;         // ours stay out of the way of the four that the program gets
constexpr int pollMilliseconds = 10;  // how late the end of a program is seen whose children hold its output
constexpr int cannotStart = 127;
constexpr double mostWaiting = 5.0;  // limits of time that a program may wait for a processor

[[noreturn]] void fail(const std::string& what) { throw MachineError(what + ": " + std::strerror(errno)); }

// A descriptor of ours, closed when it goes.
class Descriptor {
public:
    Descriptor() = default;
    explicit Descriptor(int owned) : number(owned) {}
    ~Descriptor() { close(); }
    Descriptor(Descriptor&& other) noexcept : number(std::exchange(other.number, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number, other.number);
        return *this;
    }
    int get() const { return number; }
    bool open() const { return number >= 0; }
    void close() {
        if (number >= 0) ::close(number);
        number = -1;
    }

private:
    int number = -1;
};

struct Pipe {
    Descriptor reading, writing;
};

Descriptor moved(int number) {
    const Descriptor low(number);
    Descriptor high(fcntl(number, F_DUPFD_CLOEXEC, firstFree));
    if (!high.open()) fail("no file descriptor is left");
    return high;
}

Pipe makePipe() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) fail("no pipe could be made");
    Pipe made;
    made.reading = moved(ends[0]);
    made.writing = moved(ends[1]);
    return made;
}

void limit(int resource, std::size_t value) {
    const rlimit both = {value, value};
    setrlimit(static_cast<__rlimit_resource>(resource), &both);
}

// Between fork and exec: calls that are safe there, and nothing else.
[[noreturn]] void become(char* const* arguments, char* const* environment, const char* folder, const Pipe& in,
                         const Pipe& out, const Pipe& answer, const ProcessLimits& limits) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    dup2(in.reading.get(), 0);
    dup2(out.writing.get(), 1);
    dup2(out.writing.get(), 2);
    dup2(answer.writing.get(), answerDescriptor);
    close_range(answerDescriptor + 1, ~0u, 0);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, limits.file);
    if (limits.memory) limit(RLIMIT_AS, limits.memory);
    // Beyond what the judge allows, so that the judge comes first, whose reckoning of waiting is not to the second.
    if (limits.seconds > 0) limit(RLIMIT_CPU, static_cast<std::size_t>(std::ceil(2.0 * limits.seconds)) + 1);
    signal(SIGPIPE, SIG_DFL);
    if (chdir(folder) == 0) execve(arguments[0], arguments, environment);
    _exit(cannotStart);
}

std::vector<char*> pointers(const std::vector<std::string>& texts) {
    std::vector<char*> all;
    for (const std::string& text : texts) all.push_back(const_cast<char*>(text.c_str()));
    all.push_back(nullptr);
    return all;
}

// The conversation with a program that runs.
class Running {
public:
    Running(const Command& command, std::string_view toSend, const ProcessLimits& within)
        : program(command.arguments[0]),
          input(toSend),
          limits(within),
          in(makePipe()),
          out(makePipe()),
          answer(makePipe()) {
        const std::vector<char*> arguments = pointers(command.arguments), environment = pointers(command.environment);
        process = vfork();  // a copy of the judge's page tables would take longer than many a check
        if (process < 0) fail("no process could be made");
        if (process == 0) become(arguments.data(), environment.data(), command.folder.c_str(), in, out, answer, limits);
        setpgid(process, process);  // in both, so that it holds whichever comes first
        in.reading.close();
        out.writing.close();
        answer.writing.close();
        for (const int end : {in.writing.get(), out.reading.get(), answer.reading.get()})
            fcntl(end, F_SETFL, O_NONBLOCK);
    }
    ~Running() {
        kill(-process, SIGKILL);
        if (!reaped) waitpid(process, nullptr, 0);
    }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;

    Ended finish() {
        while (!hasEnded()) {
            if (limits.seconds > 0 && isOverdue()) break;
            exchange(pollMilliseconds);
        }
        kill(-process, SIGKILL);
        exchange(0);
        ended.seconds = watch.seconds();
        return std::move(ended);
    }

private:
    bool hasEnded() {
        int status = 0;
        if (waitpid(process, &status, WNOHANG) != process) return false;
        reaped = true;
        ended.how = WIFSIGNALED(status) ? Ended::How::signalled : Ended::How::exited;
        ended.code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
        return true;
    }

    bool isOverdue() {
        const double now = watch.seconds();
        wait.look(process, now);
        if (wait.seconds() > mostWaiting * limits.seconds)
            throw MachineError("this machine is too busy: " + program + " waited for a processor for " +
                               durationText(wait.seconds()) + "; run it again with fewer programs beside it");
        if (now - wait.seconds() <= limits.seconds) return false;
        ended.how = Ended::How::timedOut;
        return true;
    }

    // Moves what can be moved. When all three pipes are closed, the end is near: a short sleep.
    void exchange(int milliseconds) {
        std::array<pollfd, 3> ends = {
            {{in.writing.get(), POLLOUT, 0}, {out.reading.get(), POLLIN, 0}, {answer.reading.get(), POLLIN, 0}}};
        if (!in.writing.open() && !out.reading.open() && !answer.reading.open()) {
            if (milliseconds) std::this_thread::sleep_for(std::chrono::microseconds(200));
            return;
        }
        if (poll(ends.data(), ends.size(), milliseconds) <= 0) return;
        if (ends[0].revents) feed();
        if (ends[1].revents) take(out.reading, ended.output, limits.output, ended.outputCut);
        bool tooLong = false;
        if (ends[2].revents) take(answer.reading, ended.answer, limits.answer, tooLong);
    }

    void feed() {
        const ssize_t written = input.empty() ? 0 : write(in.writing.get(), input.data(), input.size());
        if (written > 0) input.remove_prefix(static_cast<std::size_t>(written));
        if (input.empty() || (written < 0 && errno != EAGAIN)) in.writing.close();
    }

    // Reads all that is there, so that a program that prints without end is slowed by nothing but itself.
    static void take(Descriptor& from, std::string& to, std::size_t most, bool& cut) {
        std::array<char, 1 << 16> buffer;
        for (int blocks = 0; blocks < 64; ++blocks) {
            const ssize_t got = read(from.get(), buffer.data(), buffer.size());
            if (got < 0 && errno == EAGAIN) return;
            if (got <= 0) {
                from.close();
                return;
            }
            const std::size_t room = most - std::min(most, to.size());
            to.append(buffer.data(), std::min(room, static_cast<std::size_t>(got)));
            cut = cut || static_cast<std::size_t>(got) > room;
        }
    }

    std::string program;
    std::string_view input;
    const ProcessLimits& limits;
    Stopwatch watch;
    ProcessorWait wait;
    Pipe in, out, answer;
    pid_t process = -1;
    bool reaped = false;
    Ended ended;
};

}  // namespace

Ended run(const Command& command, std::string_view input, const ProcessLimits& limits) {
    RADLAB_CHECK(!command.arguments.empty());
    static const auto ignored = signal(SIGPIPE, SIG_IGN);  // a program that does not read its input
    (void)ignored;
    if (access(command.arguments[0].c_str(), X_OK) != 0) fail(command.arguments[0] + ": cannot be started");
    Ended ended = Running(command, input, limits).finish();
    if (ended.how == Ended::How::exited && ended.code == cannotStart && ended.answer.empty() && ended.output.empty())
        throw MachineError(command.arguments[0] + ": could not be started");
    return ended;
}

std::vector<std::string> protections() {
    return {"process group",
            "no new privileges",
            "closed descriptors",
            "cleared environment",
            "limits of time, memory and files",
            "capped output"};
}

}  // namespace radlab::grader
