#include "grader/batch/FileLock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <thread>

#include "base/Error.h"
#include "grader/protocol/PlainText.h"

namespace radlab::grader {

namespace {

constexpr int triesWhileItLives = 100, tries = 6000;
constexpr std::chrono::milliseconds pause{10};

std::string holderOf(int file) {
    std::array<char, 32> text{};
    const ssize_t length = pread(file, text.data(), text.size(), 0);
    return length > 0 ? visibleText({text.data(), static_cast<std::size_t>(length)}) : "?";
}

bool lives(const std::string& process) {
    const int number = std::atoi(process.c_str());
    return number > 0 && (kill(number, 0) == 0 || errno == EPERM);
}

// Where the holder was killed, what it started goes in a moment, which is long on a busy machine.
bool lock(int file) {
    for (int i = 0; i < tries; ++i) {
        if (flock(file, LOCK_EX | LOCK_NB) == 0) return true;
        if ((errno != EWOULDBLOCK && errno != EINTR) || (i >= triesWhileItLives && lives(holderOf(file)))) return false;
        std::this_thread::sleep_for(pause);
    }
    return false;
}

}  // namespace

FileLock::FileLock(const std::filesystem::path& file, const std::string& what) {
    const int number = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (number < 0) throw Error({file.string()}, std::string("cannot be written: ") + std::strerror(errno));
    held = moved(number);
    if (!lock(held.get()))
        throw Error({file.string()},
                    what + " (process " + holderOf(held.get()) + ") is at work here: wait for its end, or stop it");
    const std::string process = std::to_string(getpid());
    if (ftruncate(held.get(), 0) != 0 || pwrite(held.get(), process.data(), process.size(), 0) < 0)
        throw Error({file.string()}, std::string("cannot be written: ") + std::strerror(errno));
}

}  // namespace radlab::grader
