#include "grader/sandbox/Process.h"

#include <sys/auxv.h>

#include "base/Interrupts.h"
#include "grader/sandbox/Conversation.h"
#include "grader/sandbox/Deadline.h"
#include "grader/sandbox/Launch.h"

namespace radlab::grader {

namespace {

constexpr int pollMilliseconds = 10;  // how late the end of a program is seen whose children hold its output

}  // namespace

std::filesystem::path ownProgram() {
    return std::filesystem::canonical(reinterpret_cast<const char*>(getauxval(AT_EXECFN)));
}

std::string howItEnded(const Ended& ended) {
    if (ended.how == Ended::How::timedOut) return "took too long";
    return (ended.how == Ended::How::signalled ? "was stopped by signal " : "ended with exit code ") +
           std::to_string(ended.code);
}

Ended run(const Command& command, std::string_view input, const ProcessLimits& limits) {
    RADLAB_CHECK(!command.arguments.empty());
    Conversation conversation(input, limits);
    Launched program(command, limits, conversation.input(), conversation.output(), conversation.answer());
    conversation.begun();
    Deadline deadline(command.arguments[0], program.process(), limits.seconds);
    Ended ended;
    while (!program.hasEnded(ended)) {
        if (deadline.isOver()) {
            ended.how = Ended::How::timedOut;
            break;
        }
        if (limits.stoppable) Interrupts::check();
        conversation.exchange(pollMilliseconds);
    }
    program.stop();
    conversation.finish(ended);
    ended.seconds = deadline.seconds();
    if (ended.how == Ended::How::exited && ended.code == cannotStart && ended.answer.empty() && ended.output.empty())
        throw MachineError(command.arguments[0] + ": could not be started");
    return ended;
}

}  // namespace radlab::grader
