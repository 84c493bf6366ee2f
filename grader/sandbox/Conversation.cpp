#include "grader/sandbox/Conversation.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <thread>
#include <utility>

namespace radlab::grader {

Conversation::Conversation(std::string_view input, const ProcessLimits& within)
    : toSend(input), limits(within), in(makePipe()), out(makePipe()), reply(makePipe()) {
    static const auto ignored = signal(SIGPIPE, SIG_IGN);  // a program that does not read its input
    (void)ignored;
    for (const Descriptor* end : {&in.writing, &out.reading, &reply.reading}) makeNonBlocking(*end);
}

void Conversation::begun() {
    in.reading.close();
    out.writing.close();
    reply.writing.close();
}

// When all pipes are closed, the end is near: a short sleep.
void Conversation::exchange(int milliseconds, int also) {
    std::array<pollfd, 4> ends = {{{in.writing.get(), POLLOUT, 0},
                                   {out.reading.get(), POLLIN, 0},
                                   {reply.reading.get(), POLLIN, 0},
                                   {also, POLLIN, 0}}};
    if (std::all_of(ends.begin(), ends.end(), [](const pollfd& end) { return end.fd < 0; })) {
        if (milliseconds) std::this_thread::sleep_for(std::chrono::microseconds(200));
        return;
    }
    if (poll(ends.data(), ends.size(), milliseconds) <= 0) return;
    if (ends[0].revents) feed();
    if (ends[1].revents) take(out.reading, taken.output, limits.output, taken.outputCut);
    if (ends[2].revents) take(reply.reading, taken.answer, limits.answer, answerCut);
}

void Conversation::feed() {
    const ssize_t written = toSend.empty() ? 0 : write(in.writing.get(), toSend.data(), toSend.size());
    if (written > 0) toSend.remove_prefix(static_cast<std::size_t>(written));
    if (toSend.empty() || (written < 0 && errno != EAGAIN)) in.writing.close();
}

// Reads all that is there, so that a program that prints without end is slowed by nothing but itself.
void Conversation::take(Descriptor& from, std::string& to, std::size_t most, bool& cut) {
    std::array<char, 1 << 16> buffer;
    for (int blocks = 0; blocks < 64; ++blocks) {
        const ssize_t got = read(from.get(), buffer.data(), buffer.size());
        if (got < 0 && errno == EAGAIN) return;
        if (got <= 0) {
            from.close();
            return;
        }
        const std::size_t room = most - std::min(most, to.size());
        to.append(buffer.data(), std::min(room, static_cast<std::size_t>(got)));
        cut = cut || static_cast<std::size_t>(got) > room;
    }
}

void Conversation::finish(Ended& ended) {
    exchange(0);
    ended.output = std::move(taken.output);
    ended.outputCut = taken.outputCut;
    ended.answer = std::move(taken.answer);
}

}  // namespace radlab::grader
