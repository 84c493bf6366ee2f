#include "grader/sandbox/Process.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <thread>

#include <doctest/doctest.h>

#include "base/Interrupts.h"
#include "base/Stopwatch.h"
#include "base/TestFolder.h"
#include "base/WholeFile.h"

using namespace radlab;
using namespace radlab::grader;

namespace {

Ended shell(const std::string& script, const std::string& input = "", const ProcessLimits& limits = {}) {
    return run({{"/bin/sh", "-c", script}}, input, limits);
}

const std::string onThatProcessor =
    "cpu=$(taskset -cp $$ | sed 's/.*: //; s/[-,].*//'); taskset -cp $cpu $$ > /dev/null; ";
const std::string loops = "i=0; while [ $((i += 1)) -le 16 ]; do (while :; do :; done) & done; ";

// On a machine that others keep busy, a try may end as a MachineError, and rightly so.
template <class Try>
bool withinFiveTries(const Try& attempt) {
    for (int i = 0; i < 5; ++i) {
        try {
            if (attempt()) return true;
        } catch (const MachineError&) {
        }
    }
    return false;
}

// Sixteen programs on one processor, from its making on and for some seconds.
class BusyProcessor {
public:
    explicit BusyProcessor(double seconds) {
        limits.seconds = seconds;
        const std::string flag = (folder / "begun").string();
        running = std::thread([this, flag] { shell(onThatProcessor + loops + ": > " + flag + "; wait", "", limits); });
        while (!std::filesystem::exists(flag)) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    ~BusyProcessor() { running.join(); }
    BusyProcessor(const BusyProcessor&) = delete;
    BusyProcessor& operator=(const BusyProcessor&) = delete;

private:
    test::Folder folder;
    ProcessLimits limits;
    std::thread running;
};

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

TEST_CASE("waiting for a processor is not running: it has a limit of its own") {
    ProcessLimits limits;
    limits.seconds = 1.0;
    CHECK(withinFiveTries([&] {
        const BusyProcessor busy(1.5);
        const Ended late =
            shell(onThatProcessor + "i=0; while [ $((i += 1)) -le 80000 ]; do :; done; exit 7", "", limits);
        CHECK(late.how == Ended::How::exited);
        CHECK(late.code == 7);
        return late.seconds > limits.seconds;
    }));
    limits.seconds = 0.3;
    const BusyProcessor busy(4.0);
    CHECK_THROWS_AS(shell(onThatProcessor + "exec nice -n 19 sh -c 'while :; do :; done'", "", limits), MachineError);
}

TEST_CASE("a program that keeps the processors from itself by its own children is stopped at its limit") {
    ProcessLimits limits;
    limits.seconds = 0.5;
    CHECK(withinFiveTries([&] {
        return shell(onThatProcessor + loops + "exec nice -n 19 sh -c 'while :; do :; done'", "", limits).how ==
               Ended::How::timedOut;
    }));
}

TEST_CASE("output is cut where it is too long, and a flood does not fill the memory") {
    ProcessLimits limits;
    limits.output = 1000;
    const Ended ended = shell("head -c 100000000 /dev/zero", "", limits);
    CHECK(ended.code == 0);
    CHECK(ended.output.size() == 1000);
    CHECK(ended.outputCut);
    limits.seconds = 2.0;  // room to wait on a busy machine: five times that is too busy
    CHECK(shell("cat /dev/zero >&3", "", limits).answer.size() <= limits.answer);
}

TEST_CASE("a child that holds the output is not waited for, and is killed") {
    Stopwatch watch;
    const Ended ended = shell("sleep 60 & echo $! >&3; exit 0");
    CHECK(ended.code == 0);
    CHECK(watch.seconds() < 30.0);
    const pid_t child = std::stoi(ended.answer);
    bool gone = false;
    for (int i = 0; i < 1000 && !gone; ++i) {
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
