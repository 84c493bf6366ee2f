// Looks through an archive of a stranger for the files that are wanted; started by the grader, in a process of its own.
//
//   unpack RULES: the archive comes on standard input, the answer goes to file descriptor 3.

#include <unistd.h>

#include <array>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

#include "base/Error.h"
#include "grader/intake/Archive.h"
#include "grader/intake/UnpackMessage.h"

using namespace radlab::grader;

namespace {

constexpr int answers = 3;

std::string received(std::size_t most) {
    std::string bytes;
    std::array<char, 1 << 16> block;
    for (ssize_t got; (got = read(STDIN_FILENO, block.data(), block.size())) > 0;) {
        bytes.append(block.data(), static_cast<std::size_t>(got));
        if (bytes.size() > most) throw radlab::Error("the archive is larger than the rules allow");
    }
    return bytes;
}

void send(const std::string& answer) {
    std::size_t sent = 0;
    while (sent < answer.size()) {
        const ssize_t written = write(answers, answer.data() + sent, answer.size() - sent);
        if (written <= 0) throw radlab::Error("nobody takes the answer");
        sent += static_cast<std::size_t>(written);
    }
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) return 2;
    try {
        const IntakeRules rules = rulesFromText(arguments[1]);
        send(toCbor(readArchive(received(rules.mostArchive), rules)));
    } catch (const std::exception& exception) {
        std::cerr << "unpack: " << exception.what() << '\n';
        return 3;
    }
    return 0;
}
