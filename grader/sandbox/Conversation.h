#pragma once

#include <string_view>

#include "grader/sandbox/Pipes.h"
#include "grader/sandbox/Process.h"

namespace radlab::grader {

/// The three pipes to a program that runs: what it is told, what it prints, what it answers.
class Conversation {
public:
    /// The input must outlive this.
    Conversation(std::string_view input, const ProcessLimits& limits);

    /// The program's ends: descriptors 0, 1 and 2, and 3; closed here by `begun`.
    int input() const { return in.reading.get(); }
    int output() const { return out.writing.get(); }
    int answer() const { return reply.writing.get(); }

    /// To be called as soon as the program holds its ends.
    void begun();

    /// Moves what can be moved, or waits so long for that; `also` is a descriptor whose input ends the wait, or -1.
    void exchange(int milliseconds, int also = -1);

    /// What came so far, put where it belongs.
    void finish(Ended& ended);

private:
    void feed();
    static void take(Descriptor& from, std::string& to, std::size_t most, bool& cut);

    std::string_view toSend;
    const ProcessLimits& limits;
    Pipe in, out, reply;
    Ended taken;
    bool answerCut = false;
};

}  // namespace radlab::grader
