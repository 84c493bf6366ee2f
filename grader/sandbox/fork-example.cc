// The other end of the tests of ForkServer: does what its input says.

#include <sys/syscall.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstring>
#include <string>

#include "grader/sandbox/ServeForks.h"

namespace {

int runs = 0;

[[noreturn]] void work() {
    std::string input;
    char block[256];
    for (ssize_t got; (got = read(0, block, sizeof block)) > 0;) input.append(block, static_cast<std::size_t>(got));
    dprintf(1, "runs %d\n", ++runs);
    const std::size_t space = input.find(' ');
    const std::string word = input.substr(0, space), rest = input.substr(space + 1);
    if (word == "answer") dprintf(3, "%s", rest.c_str());
    if (word == "crash") syscall(__NR_tgkill, getpid(), gettid(), SIGKILL);
    if (word == "hang") pause();
    if (word == "down") kill(getppid(), SIGKILL);
    _exit(word == "exit" ? 9 : 0);
}

}  // namespace

int main() {
    radlab::grader::serveForks(work);
    return 0;
}
