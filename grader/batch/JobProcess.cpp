#include "grader/batch/JobProcess.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <exception>
#include <filesystem>
#include <utility>

#include "base/Error.h"
#include "base/Interrupts.h"
#include "base/ProgressBar.h"
#include "grader/protocol/PlainText.h"
#include "grader/sandbox/Process.h"

namespace radlab::grader {

namespace {

// An answer is its length, a letter that says what it is, and as many bytes.
constexpr std::size_t headLength = sizeof(std::uint64_t) + 1;
constexpr char isAnswer = 'a', isFault = 'f';

constexpr std::size_t mostWords = 2000;  // bytes of what a process printed that are told

// Where there is no /proc, nobody knows.
bool hasOtherThreads() {
    std::error_code failure;
    const std::filesystem::directory_iterator threads("/proc/self/task", failure);
    return !failure && std::distance(begin(threads), end(threads)) > 1;
}

void writeAll(int to, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = write(to, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) _exit(1);
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

void answerWith(int to, char kind, std::string_view bytes) {
    const std::uint64_t length = bytes.size();
    std::array<char, headLength> head;
    std::memcpy(head.data(), &length, sizeof length);
    head.back() = kind;
    writeAll(to, {head.data(), head.size()});
    writeAll(to, bytes);
}

}  // namespace

JobProcess::JobProcess(const std::function<std::string()>& work, double seconds, std::size_t mostBytes)
    : mostSeconds(seconds), most(mostBytes) {
    RADLAB_CHECK(!hasOtherThreads());
    Pipe pipe = makePipe();
    printed = memoryFile("");
    const pid_t parent = getpid();
    process = fork();
    if (process < 0) failWithErrno("no process could be made");
    if (process == 0) perform(work, pipe.writing.get(), printed.get(), parent);
    setpgid(process, process);  // in both, so that it holds whichever comes first
    deadline.emplace("the judge's process", process, mostSeconds);
    answers = std::move(pipe.reading);
    makeNonBlocking(answers);
}

JobProcess::~JobProcess() {
    if (process < 0 || reaped) return;
    kill(-process, SIGKILL);
    waitpid(process, nullptr, 0);
}

// Nothing that was made before the fork may be destroyed here: the process ends by _exit, whatever comes.
void JobProcess::perform(const std::function<std::string()>& work, int answer, int output, pid_t parent) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(1);  // it went before the line above
    Interrupts::forget();
    dup2(open("/dev/null", O_RDONLY | O_CLOEXEC), 0);
    dup2(output, 1);
    dup2(output, 2);
    close_range(3, static_cast<unsigned>(answer) - 1, 0);
    close_range(static_cast<unsigned>(answer) + 1, ~0u, 0);
    try {
        answerWith(answer, isAnswer, work());
    } catch (const std::exception& fault) {
        answerWith(answer, isFault, fault.what());
    } catch (...) {
        answerWith(answer, isFault, "something was thrown that is no exception");
    }
    _exit(0);
}

std::optional<JobEnd> JobProcess::look() {
    read();
    if (std::optional<JobEnd> end = answer()) return end;
    if (!answers.open())
        if (std::optional<JobEnd> end = death()) return end;
    return lateness();
}

// Not more than a share at a time, so that one does not keep the others waiting.
void JobProcess::read() {
    std::array<char, 1 << 16> buffer;
    for (int blocks = 0; blocks < 64 && answers.open() && got.size() <= most + headLength; ++blocks) {
        const ssize_t length = ::read(answers.get(), buffer.data(), buffer.size());
        if (length < 0 && (errno == EAGAIN || errno == EINTR)) return;
        if (length <= 0) answers.close();
        if (length > 0) got.append(buffer.data(), static_cast<std::size_t>(length));
    }
}

std::optional<JobEnd> JobProcess::answer() const {
    if (got.size() < headLength) return std::nullopt;
    std::uint64_t length = 0;
    std::memcpy(&length, got.data(), sizeof length);
    if (length > most)
        return JobEnd{false, "the answer is too long: found " + std::to_string(length) + " bytes, expected at most " +
                                 std::to_string(most)};
    if (got.size() < headLength + length) return std::nullopt;
    const std::string bytes = got.substr(headLength, length);
    if (got[headLength - 1] == isAnswer) return JobEnd{true, bytes};
    return JobEnd{false, visibleText(bytes)};
}

// The end of its answers comes a moment before its own.
std::optional<JobEnd> JobProcess::death() {
    int status = 0;
    if (waitpid(process, &status, WNOHANG) != process) return std::nullopt;
    reaped = true;
    const std::string how = WIFSIGNALED(status) ? "was stopped by signal " + std::to_string(WTERMSIG(status))
                                                : "ended with exit code " + std::to_string(WEXITSTATUS(status));
    return JobEnd{false, "the judge's process " + how + " without an answer" + lastWords()};
}

std::optional<JobEnd> JobProcess::lateness() {
    try {
        if (deadline->isOver()) return JobEnd{false, "took longer than " + durationText(mostSeconds)};
    } catch (const MachineError& busy) {
        return JobEnd{false, busy.what()};
    }
    return std::nullopt;
}

std::string JobProcess::lastWords() const {
    const off_t length = lseek(printed.get(), 0, SEEK_END);
    std::array<char, mostWords> words;
    const ssize_t taken =
        pread(printed.get(), words.data(), words.size(), std::max<off_t>(0, length - static_cast<off_t>(mostWords)));
    return taken > 0 ? "; its last words: " + visibleText({words.data(), static_cast<std::size_t>(taken)}) : "";
}

}  // namespace radlab::grader
