#include "grader/judge/WorkerOpenGl.h"

#include <cstdlib>

#include "grader/sandbox/Process.h"

namespace radlab::grader {

void chooseOpenGl(Command& worker) {
    if (const char* kind = std::getenv("RADLAB_GL")) worker.environment.push_back(std::string("RADLAB_GL=") + kind);
}

std::string openGlOf(const Toolchain& toolchain) {
    Command command;
    command.arguments = {toolchain.worker.string(), "about"};
    chooseOpenGl(command);
    return run(command, "", {}).output;
}

}  // namespace radlab::grader
