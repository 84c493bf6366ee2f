#include "grader/judge/Worker.h"

#include <algorithm>
#include <csignal>
#include <random>

#include "base/ProgressBar.h"
#include "grader/judge/WorkerOpenGl.h"
#include "grader/sandbox/Process.h"

namespace radlab::grader {

namespace {

constexpr double slowdown = 6.0;  // by the sanitizers

std::uint64_t newNonce() {
    std::random_device source;
    return (static_cast<std::uint64_t>(source()) << 32) | source();
}

Command workerCommand(const std::filesystem::path& library, const Toolchain& toolchain, const Manifest& manifest,
                      bool drawing) {
    Command command;
    Box& box = command.box.emplace(toolchain.sandbox);
    box.calls = Calls::server;
    box.memory = static_cast<std::size_t>(manifest.mebibytes) << 20;
    box.processFiles = toolchain.sanitized;
    const std::filesystem::path worker = box.show(readableByAll(toolchain.worker, box.sandbox), "/judge/worker");
    const std::filesystem::path submission = box.show(library, "/submission/submission.so");
    command.arguments = {worker.string(), drawing ? "drawing" : "plain", submission.string()};
    // No threads in the software renderer: as many processes as there are cores run already.
    for (const char* setting :
         {"LP_NUM_THREADS=0", "MESA_SHADER_CACHE_DISABLE=true",
          "ASAN_OPTIONS=detect_leaks=0:abort_on_error=0:handle_segv=0", "UBSAN_OPTIONS=print_stacktrace=1"})
        command.environment.emplace_back(setting);
    chooseOpenGl(command);
    return command;
}

ProcessLimits limitsOf(const Toolchain& toolchain, const Manifest& manifest) {
    ProcessLimits limits;
    limits.seconds = manifest.seconds * (toolchain.sanitized ? slowdown : 1.0);
    limits.memory = toolchain.sanitized ? 0  // the sanitizers reserve terabytes
                                        : static_cast<std::size_t>(manifest.mebibytes) << 20;
    return limits;
}

std::string signalText(int number) {
    const std::string text = "stopped by signal " + std::to_string(number);
    switch (number) {
        case SIGSEGV: return text + " (memory access outside of what is there: a bad pointer or index)";
        case SIGABRT: return text + " (abort: a failed assert, or an exception nobody caught)";
        case SIGFPE: return text + " (division of an integer by zero)";
        case SIGILL: return text + " (illegal instruction: often a function without a return)";
        case SIGXCPU: return text + " (too much processor time)";
        case SIGXFSZ: return text + " (a file was written, or was too large)";
        case SIGKILL: return text + " (killed)";
        default: return text;
    }
}

std::string causeOf(const Ended& ended, const std::string& function, double seconds) {
    const std::string where = function.empty() ? " before any function was called" : " in " + function;
    if (ended.how == Ended::How::timedOut)
        return "took longer than " + durationText(seconds) + where + ": look for a loop without an end";
    if (ended.how == Ended::How::signalled) return signalText(ended.code) + where;
    return "the program ended by itself, with exit code " + std::to_string(ended.code) + "," + where +
           " (or closed the way to the judge): no verdict can come from there";
}

}  // namespace

Worker::Worker(const std::filesystem::path& library, const Toolchain& toolchain, const Manifest& manifest)
    : slower(toolchain.sanitized ? slowdown : 1.0),
      plain(workerCommand(library, toolchain, manifest, false), limitsOf(toolchain, manifest)),
      drawing(workerCommand(library, toolchain, manifest, true), limitsOf(toolchain, manifest)) {}

WorkerRun Worker::run(const std::vector<Step>& steps, double seconds) {
    const std::uint64_t nonce = newNonce();
    ForkServer& server = std::any_of(steps.begin(), steps.end(), draws) ? drawing : plain;
    const Ended ended = server.run(requestToCbor(nonce, steps), seconds * slower);
    WorkerRun made;
    made.run.answers = answersFromRecords(ended.answer, nonce, steps);
    made.output = ended.output;
    made.seconds = ended.seconds;
    made.timedOut = ended.how == Ended::How::timedOut;
    const std::size_t answered = made.run.answers.size();
    if (answered == steps.size()) return made;
    const bool loading = answered == 1 && made.run.answers[0].stop.kind == Stop::Kind::load;
    if (!loading) made.run.cause = causeOf(ended, steps[answered].function, seconds * slower);
    return made;
}

}  // namespace radlab::grader
