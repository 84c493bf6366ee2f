#include "grader/judge/Worker.h"

#include <csignal>
#include <random>

#include "base/ProgressBar.h"
#include "grader/sandbox/Process.h"

namespace radlab::grader {

namespace {

std::uint64_t newNonce() {
    std::random_device source;
    return (static_cast<std::uint64_t>(source()) << 32) | source();
}

Command workerCommand(const std::filesystem::path& library, const Toolchain& toolchain) {
    Command command;
    command.arguments = {toolchain.worker.string(), library.string()};
    // No threads in the software renderer: as many processes as there are cores run already.
    for (const char* setting :
         {"LP_NUM_THREADS=0", "MESA_SHADER_CACHE_DISABLE=true",
          "ASAN_OPTIONS=detect_leaks=0:abort_on_error=0:handle_segv=0", "UBSAN_OPTIONS=print_stacktrace=1"})
        command.environment.emplace_back(setting);
    return command;
}

ProcessLimits limitsOf(const Toolchain& toolchain, const Manifest& manifest, double seconds) {
    ProcessLimits limits;
    limits.seconds = seconds;
    limits.memory = static_cast<std::size_t>(manifest.mebibytes) << 20;
    if (toolchain.sanitized) {
        limits.memory = 0;  // the sanitizers reserve terabytes
        limits.seconds *= 6;
    }
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

std::string causeOf(const Ended& ended, const std::string& function, const ProcessLimits& limits) {
    const std::string where = function.empty() ? " before any function was called" : " in " + function;
    if (ended.how == Ended::How::timedOut)
        return "took longer than " + durationText(limits.seconds) + where + ": look for a loop without an end";
    if (ended.how == Ended::How::signalled) return signalText(ended.code) + where;
    return "the program ended by itself, with exit code " + std::to_string(ended.code) + "," + where +
           " (or closed the way to the judge): no verdict can come from there";
}

}  // namespace

WorkerRun runWorker(const std::filesystem::path& library, const std::vector<Step>& steps, const Toolchain& toolchain,
                    const Manifest& manifest, double seconds) {
    const Request request{newNonce(), steps};
    const ProcessLimits limits = limitsOf(toolchain, manifest, seconds);
    const Ended ended = run(workerCommand(library, toolchain), toCbor(request), limits);
    WorkerRun made;
    made.run.answers = answersFromRecords(ended.answer, request);
    made.output = ended.output;
    made.seconds = ended.seconds;
    made.timedOut = ended.how == Ended::How::timedOut;
    const std::size_t answered = made.run.answers.size();
    if (answered == steps.size()) return made;
    const bool loading = answered == 1 && made.run.answers[0].stop.kind == Stop::Kind::load;
    if (!loading) made.run.cause = causeOf(ended, steps[answered].function, limits);
    return made;
}

std::string workerProblem(const Toolchain& toolchain, const Manifest& manifest) {
    try {
        const Ended ended = run(workerCommand("", toolchain), toCbor({newNonce(), {}}),
                                limitsOf(toolchain, manifest, manifest.seconds));
        if (ended.how == Ended::How::exited && ended.code == 0) return "";
        return "the worker does not start on this machine: " +
               (ended.output.empty() ? "no reason given" : ended.output);
    } catch (const Error& error) {
        return error.what();
    }
}

}  // namespace radlab::grader
