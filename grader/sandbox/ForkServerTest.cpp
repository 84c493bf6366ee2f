#include "grader/sandbox/ForkServer.h"

#include <csignal>

#include <doctest/doctest.h>

#include "base/Interrupts.h"

using namespace radlab;
using namespace radlab::grader;

namespace {

// fork-server-example: does what its input says, in a process forked for it.
Command example() {
    Command command;
    Box& box = command.box.emplace(machineSandbox());
    box.calls = Calls::server;
    command.arguments = {box.show(readableByAll(RADLAB_FORK_EXAMPLE, box.sandbox), "/judge/example").string()};
#ifdef RADLAB_SANITIZED
    box.processFiles = true;
#endif
    return command;
}

ProcessLimits ofExample() {
    ProcessLimits limits;
#ifdef RADLAB_SANITIZED
    limits.memory = 0;
#endif
    return limits;
}

}  // namespace

TEST_CASE("each run has a process, an input, an output and an answer of its own") {
    ForkServer server(example(), ofExample());
    for (const char* word : {"one", "two"}) {
        const Ended ended = server.run(std::string("answer ") + word, 10.0);
        CHECK(ended.how == Ended::How::exited);
        CHECK(ended.code == 0);
        CHECK(ended.answer == word);
        CHECK(ended.output == "runs 1\n");  // counted in the process itself: no run sees another's memory
    }
}

TEST_CASE("a crash and a hang end one run, and say how") {
    ForkServer server(example(), ofExample());
    const Ended crashed = server.run("crash ", 10.0);
    CHECK(crashed.how == Ended::How::signalled);
    CHECK(crashed.code == SIGKILL);
    CHECK(server.run("answer x", 10.0).answer == "x");
    CHECK(server.run("hang ", 0.3).how == Ended::How::timedOut);
    CHECK(server.run("answer y", 10.0).answer == "y");
    CHECK(server.run("exit ", 10.0).code == 9);
}

TEST_CASE("a server that was brought down is started again") {
    Command command = example();
    command.box->sandbox.filter = false;  // else the attempt fails
    ForkServer server(command, ofExample());
    CHECK(server.run("down ", 5.0).how != Ended::How::exited);
    CHECK(server.run("answer z", 10.0).answer == "z");
}

TEST_CASE("what kept a run from its end does not keep the next one") {
    Command command;
    command.arguments = {RADLAB_FORK_EXAMPLE};
    ForkServer server(command, ofExample());
    CHECK(server.run("answer x", 10.0).answer == "x");
    {
        const Interrupts interrupts;
        raise(SIGINT);
        CHECK_THROWS_AS(server.run("hang ", 100000.0), Interrupted);
    }
    CHECK(server.run("answer y", 10.0).answer == "y");
}

TEST_CASE("a program that serves no forks is an error of the machine, with what it printed") {
    Command command{{"/bin/sh", "-c", "echo no OpenGL >&2; exit 1"}};
    ForkServer server(command, {});
    CHECK_THROWS_WITH_AS(server.run("", 1.0), doctest::Contains("no OpenGL"), MachineError);
}
