#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace radlab::grader {

/// A file descriptor of this process, closed when it goes.
class Descriptor {
public:
    Descriptor() = default;
    explicit Descriptor(int owned) : number(owned) {}
    ~Descriptor() { close(); }
    Descriptor(Descriptor&& other) noexcept : number(std::exchange(other.number, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(number, other.number);
        return *this;
    }
    int get() const { return number; }
    bool open() const { return number >= 0; }
    void close();

private:
    int number = -1;
};

/// The two ends of a pipe, or of a pair of sockets.
struct Pipe {
    Descriptor reading, writing;
};

// All are closed at exec, and have numbers out of the way of those that a program gets.
// Errors of all: MachineError, where this process or the machine has none left.

Pipe makePipe();

/// Two sockets that keep messages apart; each end reads and writes.
Pipe makeSocketPair();

/// A file without a name that holds these bytes, at its beginning.
Descriptor memoryFile(std::string_view bytes);

/// The same descriptor under such a number; the old one is closed.
Descriptor moved(int number);

void makeNonBlocking(const Descriptor& end);

/// Errors: MachineError, with what errno says.
[[noreturn]] void failWithErrno(const std::string& what);

}  // namespace radlab::grader
