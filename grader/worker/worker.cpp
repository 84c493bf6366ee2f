// Loads a submission, performs the steps of a request and answers; started by the judge, which alone knows what is right.
//
//   worker about: says which OpenGL it draws with.
//   worker plain|drawing LIBRARY: forks for each request; it comes on standard input, and the answers go to file
//   descriptor 3. One that draws has OpenGL loaded before it forks.

#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <memory>
#include <string>
#include <utility>

#include "base/Error.h"
#include "base/Heap.h"
#include "gl/Context.h"
#include "grader/sandbox/ServeForks.h"
#include "grader/worker/Steps.h"
#include "grader/worker/WarmOpenGl.h"

using namespace radlab::grader;

namespace {

constexpr int answers = 3;
constexpr std::size_t roomForRequest = std::size_t{32} << 20;

// False where the judge cannot be reached any more.
bool send(const std::string& record) {
    std::size_t sent = 0;
    while (sent < record.size()) {
        const ssize_t written = write(answers, record.data() + sent, record.size() - sent);
        if (written <= 0) return false;
        sent += static_cast<std::size_t>(written);
    }
    return true;
}

std::string received() {
    std::string bytes;
    bytes.reserve(roomForRequest);  // only what is used of it costs anything
    std::array<char, 1 << 16> block;
    for (ssize_t got; (got = read(STDIN_FILENO, block.data(), block.size())) > 0;)
        bytes.append(block.data(), static_cast<std::size_t>(got));
    return bytes;
}

// Before the judge can take the process for ended: what the submission printed is in the pipes.
void flush() {
    std::cout.flush();
    std::cerr.flush();
    std::fflush(nullptr);
}

// At once: nothing of the submission runs any more, and nobody waits for OpenGL to be taken down piece by piece.
[[noreturn]] void finish(int code) {
    flush();
    _exit(code);
}

void answerAll(const char* library, std::unique_ptr<radlab::GlContext> openGl, Request request) {
    try {
        Submission submission(library);
        Steps steps(submission, std::move(openGl));
        for (std::size_t i = 0; i < request.steps.size(); ++i) {
            StepAnswer answer = steps.perform(request.steps[i]);
            flush();
            if (!send(toRecord(answer, request.nonce, i, request.steps[i].wanted))) break;
            steps.takeBack(answer);
        }
        finish(0);
    } catch (const radlab::Error& error) {
        StepAnswer answer;
        answer.stop = {Stop::Kind::load, error.what()};
        send(toRecord(answer, request.nonce, 0, {}));
    }
}

[[noreturn]] void work(const char* library, std::unique_ptr<radlab::GlContext> openGl) {
    std::setvbuf(stdout, nullptr, _IOLBF, 1 << 16);  // so that little is lost in a crash
    try {
        answerAll(library, std::move(openGl), requestFromCbor(received()));
    } catch (const std::exception& exception) {
        std::cerr << "worker: " << exception.what() << '\n';
        finish(3);
    }
    finish(0);
}

int about() {
    try {
        std::cout << radlab::GlContext::offscreen()->description() << std::endl;
        return 0;
    } catch (const radlab::Error& error) {
        std::cout << error.what() << std::endl;
        return 3;
    }
}

}  // namespace

int main(int count, char** arguments) {
    if (count == 2 && std::strcmp(arguments[1], "about") == 0) return about();
    if (count != 3) return 2;
    radlab::keepFreedMemory();
    std::unique_ptr<radlab::GlContext> openGl;
    if (std::strcmp(arguments[1], "drawing") == 0) openGl = warmOpenGl();
    radlab::giveBackFreedMemory();
    serveForks([&] { work(arguments[2], std::move(openGl)); });
    return 0;
}
