#include "grader/intake/Unpack.h"

#include <csignal>

#include "grader/intake/UnpackMessage.h"
#include "grader/sandbox/Process.h"

namespace radlab::grader {

namespace {

constexpr std::size_t mostMemory = std::size_t{1} << 30;  // bytes

Command commandFor(const IntakeRules& rules) {
    Command command;
    Box& box = command.box.emplace(rules.sandbox ? *rules.sandbox : machineSandbox());
    box.calls = Calls::server;
    box.memory = mostMemory;
#ifdef __SANITIZE_ADDRESS__
    box.processFiles = true;
    box.memory *= 4;
#endif
    const std::filesystem::path program = box.show(readableByAll(rules.unpack, box.sandbox), "/judge/unpack");
    command.arguments = {program.string(), rulesToText(rules)};
    return command;
}

ProcessLimits limitsFor(const IntakeRules& rules) {
    ProcessLimits limits;
    limits.seconds = 20.0;
    limits.memory = mostMemory;
#ifdef __SANITIZE_ADDRESS__
    limits.memory = 0;  // the sanitizers reserve terabytes
#endif
    limits.answer = rules.files.size() * rules.mostBytes + (std::size_t{1} << 20);
    return limits;
}

// Where the box itself did not come about.
bool hadNoBox(const Ended& ended) { return ended.answer.empty() && ended.output.rfind("bwrap: ", 0) == 0; }

Gathered refused(const IntakeRules& rules, const std::string& why) {
    Gathered nothing(rules);
    nothing.remarks.refuse("the archive is refused: " + why);
    return nothing;
}

}  // namespace

Gathered unpackArchive(std::string_view bytes, const IntakeRules& rules) {
    const Ended ended = run(commandFor(rules), bytes, limitsFor(rules));
    if (ended.how == Ended::How::timedOut) return refused(rules, "it takes too long to read");
    if (ended.how == Ended::How::signalled && ended.code == SIGKILL)
        throw MachineError(rules.unpack.string() + ": killed from outside; is the memory of this machine full?");
    if (hadNoBox(ended)) throw MachineError("no box for " + rules.unpack.string() + ": " + ended.output);
    if (ended.how == Ended::How::signalled || ended.code != 0)
        return refused(rules, "it cannot be read, or takes too much memory");
    try {
        return gatheredFromCbor(ended.answer, rules);
    } catch (const Error& error) {
        return refused(rules, std::string("the program that read it gave a wrong answer (") + error.what() + ")");
    }
}

}  // namespace radlab::grader
