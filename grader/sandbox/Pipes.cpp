#include "grader/sandbox/Pipes.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "grader/sandbox/Process.h"

namespace radlab::grader {

namespace {

constexpr int firstFree = 10;  // ours stay out of the way of those that the program gets

}  // namespace

void failWithErrno(const std::string& what) { throw MachineError(what + ": " + std::strerror(errno)); }

void Descriptor::close() {
    if (number >= 0) ::close(number);
    number = -1;
}

Descriptor moved(int number) {
    const Descriptor low(number);
    Descriptor high(fcntl(number, F_DUPFD_CLOEXEC, firstFree));
    if (!high.open()) failWithErrno("no file descriptor is left");
    return high;
}

Pipe makePipe() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) failWithErrno("no pipe could be made");
    Pipe made;
    made.reading = moved(ends[0]);
    made.writing = moved(ends[1]);
    return made;
}

Pipe makeSocketPair() {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) failWithErrno("no sockets could be made");
    Pipe made;
    made.reading = moved(ends[0]);
    made.writing = moved(ends[1]);
    return made;
}

Descriptor memoryFile(std::string_view bytes) {
    const int number = memfd_create("radlab", MFD_CLOEXEC);
    if (number < 0) failWithErrno("no file in memory could be made");
    Descriptor file = moved(number);
    if (write(file.get(), bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()) ||
        lseek(file.get(), 0, SEEK_SET) != 0)
        failWithErrno("a file in memory could not be written");
    return file;
}

void makeNonBlocking(const Descriptor& end) { fcntl(end.get(), F_SETFL, O_NONBLOCK); }

}  // namespace radlab::grader
