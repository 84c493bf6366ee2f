#include "study/Command.h"

#ifdef _WIN32
#include <process.h>
#else
#include <spawn.h>
#include <sys/wait.h>

extern char** environ;
#endif

namespace radlab::study {

std::optional<int> runCommand(const std::vector<std::string>& words) {
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
#ifdef _WIN32
    const auto status = _spawnvp(_P_WAIT, arguments[0], arguments.data());
    if (status == -1) return {};
    return static_cast<int>(status);
#else
    pid_t child = 0;
    int status = 0;
    if (posix_spawnp(&child, arguments[0], nullptr, nullptr, arguments.data(), environ) != 0) return {};
    if (waitpid(child, &status, 0) != child) return {};
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
#endif
}

}  // namespace radlab::study
