#include "base/Interrupts.h"

#include <csignal>
#include <ostream>

#include <doctest/doctest.h>

#include "base/TestFolder.h"
#include "base/WholeFile.h"

#ifndef _WIN32
#include <sys/wait.h>
#include <unistd.h>
#endif

using namespace radlab;
using radlab::test::Folder;

TEST_CASE("what came is thrown wherever long work asks, until it is answered") {
    const Interrupts interrupts;
    CHECK_FALSE(Interrupts::caught());
    CHECK_NOTHROW(Interrupts::check());
    std::raise(SIGINT);
    CHECK(Interrupts::caught());
    CHECK_FALSE(doneWhole([] { Interrupts::check(); }));
    CHECK_THROWS_AS(Interrupts::check(), Interrupted);
    Interrupts::answer();
    CHECK(Interrupts::caught());
    CHECK(doneWhole([] { Interrupts::check(); }));
}

TEST_CASE("an answer before anything came answers nothing, and the next program starts afresh") {
    {
        const Interrupts interrupts;
        Interrupts::answer();
        std::raise(SIGTERM);
        CHECK_THROWS_AS(Interrupts::check(), Interrupted);
    }
    CHECK_FALSE(Interrupts::caught());
    const Interrupts again;
    CHECK_NOTHROW(Interrupts::check());
}

TEST_CASE("Ctrl-C while a file is written leaves the older one as it was, and no part of the new") {
    const Folder folder;
    writeFile(folder / "file", "older");
    const Interrupts interrupts;
    CHECK_FALSE(doneWhole([&] {
        writeFile(folder / "file", [](std::ostream& out) {
            out << "half" << std::flush;
            std::raise(SIGINT);
            Interrupts::check();
        });
    }));
    CHECK(readFile(folder / "file") == "older");
    CHECK(folder.entries() == 1);
}

#ifndef _WIN32
TEST_CASE("a second Ctrl-C while a file is written ends the program at once, and leaves no part of it") {
    const Folder folder;
    writeFile(folder / "file", "older");
    const pid_t child = fork();
    if (child == 0) {
        const Interrupts interrupts;
        writeFile(folder / "file", [&](std::ostream& out) {
            out << "half" << std::flush;
            if (folder.entries() != 2) _exit(1);
            std::raise(SIGINT);
            std::raise(SIGINT);
        });
        _exit(0);
    }
    int status = 0;
    REQUIRE(waitpid(child, &status, 0) == child);
    CHECK(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == SIGINT);
    CHECK(readFile(folder / "file") == "older");
    CHECK(folder.entries() == 1);
}
#endif
