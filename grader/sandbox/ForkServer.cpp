#include "grader/sandbox/ForkServer.h"

#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstring>
#include <string>

#include "base/Interrupts.h"
#include "grader/sandbox/Conversation.h"
#include "grader/sandbox/Deadline.h"
#include "grader/sandbox/Launch.h"

namespace radlab::grader {

namespace {

constexpr int pollTime = 10;
constexpr double secondsToStart = 30.0;

}  // namespace

struct ForkServer::Running {
    Running(const Command& command, const ProcessLimits& limits)
        : sockets(makeSocketPair()),
          talk("", limits),
          program(command, limits, talk.input(), talk.output(), sockets.writing.get()) {
        talk.begun();
        sockets.writing.close();
        makeNonBlocking(sockets.reading);
    }

    Pipe sockets;
    Conversation talk;  // what it prints itself, to say why it does not start
    Launched program;
};

ForkServer::ForkServer(Command toStart, const ProcessLimits& within) : command(std::move(toStart)), limits(within) {}

ForkServer::~ForkServer() = default;

// The first message says that it is there: what it printed else is no fault of a submission, which is not loaded yet.
void ForkServer::start() {
    running = std::make_unique<Running>(command, limits);
    Deadline deadline(command.arguments[0], running->program.process(), secondsToStart);
    char greeting = 0;
    Ended ended;
    while (recv(running->sockets.reading.get(), &greeting, 1, 0) != 1) {
        Interrupts::check();
        const bool over = running->program.hasEnded(ended);
        if (!over && !deadline.isOver()) {
            running->talk.exchange(pollTime, running->sockets.reading.get());
            continue;
        }
        if (!over) ended.how = Ended::How::timedOut;
        running->talk.finish(ended);
        running.reset();
        throw MachineError(command.arguments[0] + " does not start on this machine: " +
                           (ended.output.empty() ? "it " + howItEnded(ended) : ended.output));
    }
}

bool ForkServer::send(int input, int output, int answer) const {
    const std::array<int, 3> ends = {input, output, answer};
    std::string filter = command.box && command.box->sandbox.filter ? filterProgram(Calls::submission) : "";
    filter.insert(filter.begin(), command.box && !command.box->sandbox.bubblewrap.empty() ? 1 : 0);
    alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof ends)> control{};
    iovec bytes = {filter.data(), filter.size()};
    msghdr message = {};
    message.msg_iov = &bytes;
    message.msg_iovlen = 1;
    message.msg_control = control.data();
    message.msg_controllen = control.size();
    cmsghdr* header = CMSG_FIRSTHDR(&message);
    header->cmsg_level = SOL_SOCKET;
    header->cmsg_type = SCM_RIGHTS;
    header->cmsg_len = CMSG_LEN(sizeof ends);
    std::memcpy(CMSG_DATA(header), ends.data(), sizeof ends);
    return sendmsg(running->sockets.reading.get(), &message, MSG_NOSIGNAL) >= 0;
}

bool ForkServer::receive(Ended& ended) const {
    int status = 0;
    if (recv(running->sockets.reading.get(), &status, sizeof status, 0) != sizeof status) return false;
    ended.how = WIFSIGNALED(status) ? Ended::How::signalled : Ended::How::exited;
    ended.code = WIFSIGNALED(status) ? WTERMSIG(status) : WEXITSTATUS(status);
    return true;
}

Ended ForkServer::run(std::string_view input, double seconds) {
    try {
        return perform(input, seconds);
    } catch (...) {
        running.reset();  // whatever it is doing, the next run does not wait for that
        throw;
    }
}

Ended ForkServer::perform(std::string_view input, double seconds) {
    if (!running) start();
    Conversation conversation(input, limits);
    if (!send(conversation.input(), conversation.output(), conversation.answer())) {
        start();  // brought down after the run before
        if (!send(conversation.input(), conversation.output(), conversation.answer()))
            throw MachineError(command.arguments[0] + " ended by itself");
    }
    conversation.begun();
    Deadline deadline(command.arguments[0], running->program.process(), seconds);
    Ended ended;
    while (!receive(ended)) {
        Interrupts::check();
        const bool broughtDown = running->program.hasEnded(ended);
        if (broughtDown || deadline.isOver()) {
            ended.how = broughtDown ? Ended::How::signalled : Ended::How::timedOut;
            ended.code = broughtDown ? SIGKILL : 0;
            running.reset();
            break;
        }
        conversation.exchange(pollTime, running->sockets.reading.get());
    }
    conversation.finish(ended);
    ended.seconds = deadline.seconds();
    return ended;
}

}  // namespace radlab::grader
