#include "grader/sandbox/Process.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <thread>

#include <doctest/doctest.h>

#include "base/Interrupts.h"
#include "base/TestFolder.h"
#include "base/TestLoad.h"
#include "base/WholeFile.h"

using namespace radlab;
using namespace radlab::grader;

namespace {

Ended shell(const std::string& script, const std::string& input = "", const ProcessLimits& limits = {}) {
    return run({{"/bin/sh", "-c", script}}, input, limits);
}

// A shell's words for a program that only runs where nobody else wants that processor.
std::string starvedOn(const test::BusyProcessor& busy) {
    return "exec taskset -c " + std::to_string(busy.number()) + " chrt --idle 0 ";
}

}  // namespace

TEST_CASE("an interrupt kills the program that runs") {
    const test::Folder folder;
    const std::string number = (folder / "number").string();
    const Interrupts interrupts;
    std::atomic<bool> over{false};
    std::thread presses([&] {
        while (!over && !std::filesystem::exists(number)) std::this_thread::sleep_for(std::chrono::milliseconds(5));
        raise(SIGINT);
    });
    ProcessLimits limits;
    limits.file = 64;
    limits.seconds = 0.0;
    CHECK_THROWS_AS(
        shell("echo $$ > " + number + ".part; mv " + number + ".part " + number + "; sleep 1000", "", limits),
        Interrupted);
    over = true;
    presses.join();
    CHECK(kill(std::stoi(readFile(number)), 0) == -1);
    CHECK(errno == ESRCH);
}

TEST_CASE("a program gets its input, and its output and answer come back apart") {
    const Ended ended = shell("cat; echo to stderr >&2; echo an answer >&3; exit 7", "from us\n");
    CHECK(ended.how == Ended::How::exited);
    CHECK(ended.code == 7);
    CHECK(ended.output == "from us\nto stderr\n");
    CHECK(ended.answer == "an answer\n");
}

TEST_CASE("much passes both ways, and a program that reads nothing does no harm") {
    const std::string much(5 << 20, 'x');
    CHECK(shell("cat >&3", much).answer == much);
    CHECK(shell("exit 0", much).code == 0);
}

TEST_CASE("a signal is named, a program without end is stopped") {
    const Ended killed = shell("kill -SEGV $$");
    CHECK(killed.how == Ended::How::signalled);
    CHECK(killed.code == SIGSEGV);
    ProcessLimits limits;
    limits.seconds = 0.2;
    const Ended stopped = shell("echo begun; while :; do :; done", "", limits);
    CHECK(stopped.how == Ended::How::timedOut);
    CHECK(stopped.output == "begun\n");
}

TEST_CASE("waiting for a processor is not running") {
    ProcessLimits limits;
    limits.seconds = 1.0;
    auto busy = std::make_unique<test::BusyProcessor>();
    const std::string starved = starvedOn(*busy);
    std::thread frees([&] {
        std::this_thread::sleep_for(std::chrono::seconds(4));
        busy.reset();
    });
    const Ended late = shell(starved + "sh -c 'exit 7'", "", limits);
    frees.join();
    CHECK(late.how == Ended::How::exited);
    CHECK(late.code == 7);
}

TEST_CASE("waiting for a processor has a limit of its own, which is the machine's fault") {
    ProcessLimits limits;
    limits.seconds = 0.2;
    const test::BusyProcessor busy;
    CHECK_THROWS_WITH_AS(shell(starvedOn(busy) + "sh -c 'while :; do :; done'", "", limits),
                         doctest::Contains("this machine is too busy"), MachineError);
}

TEST_CASE("who sleeps, stops itself, or takes the processors from itself runs into its limit") {
    ProcessLimits limits;
    limits.seconds = 0.5;
    for (const char* script :
         {"exec sleep 1000", "kill -STOP $$",
          "i=0; while [ $((i += 1)) -le 40 ]; do (while :; do :; done) & done; wait", "while :; do /bin/true; done"}) {
        CAPTURE(script);
        const Ended ended = shell(script, "", limits);
        CHECK(ended.how == Ended::How::timedOut);
    }
}

TEST_CASE("output is cut where it is too long, and a flood does not fill the memory") {
    ProcessLimits limits;
    limits.output = 1000;
    const Ended ended = shell("head -c 100000000 /dev/zero", "", limits);
    CHECK(ended.code == 0);
    CHECK(ended.output.size() == 1000);
    CHECK(ended.outputCut);
    limits.seconds = 2.0;
    CHECK(shell("cat /dev/zero >&3", "", limits).answer.size() <= limits.answer);
}

TEST_CASE("a child that holds the output is not waited for, and is killed") {
    const Ended ended = shell("sleep 100000 & echo $! >&3; exit 0");
    CHECK(ended.how == Ended::How::exited);
    CHECK(ended.code == 0);
    const pid_t child = std::stoi(ended.answer);
    bool gone = false;
    for (int i = 0; i < 60000 && !gone; ++i) {
        gone = kill(child, 0) != 0;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    CHECK(gone);
}

TEST_CASE("neither our descriptors nor our environment reach a program") {
    const int ours = open("/dev/null", O_RDONLY);
    setenv("RADLAB_SECRET", "told", 1);
    const Ended ended = shell("ls /proc/self/fd | tr '\\n' ' '; env | grep SECRET; pwd");
    CHECK(ended.output == "0 1 2 3 4 /\n");  // 4 is the folder that ls reads
    close(ours);
}

TEST_CASE("memory and files have their limits") {
    ProcessLimits limits;
    limits.memory = 64 << 20;
    CHECK(shell("x=$(head -c 200000000 /dev/zero | tr '\\0' x); echo ${#x}", "", limits).output.find("200000000") ==
          std::string::npos);
    const Ended file = shell("echo text > /tmp/radlab-limit-test");
    CHECK(file.how == Ended::How::signalled);
    CHECK(file.code == SIGXFSZ);
    unlink("/tmp/radlab-limit-test");
}

TEST_CASE("several programs run at once without seeing each other") {
    std::vector<std::thread> threads;
    std::vector<Ended> all(16);
    for (std::size_t i = 0; i < all.size(); ++i)
        threads.emplace_back([&all, i] { all[i] = shell("ls /proc/self/fd | tr '\\n' ' '; cat", std::to_string(i)); });
    for (std::thread& thread : threads) thread.join();
    for (std::size_t i = 0; i < all.size(); ++i) CHECK(all[i].output == "0 1 2 3 4 " + std::to_string(i));
}

TEST_CASE("a program that is not there is an error of the machine") {
    CHECK_THROWS_AS(run({{"/nowhere/program"}}, "", {}), MachineError);
}
