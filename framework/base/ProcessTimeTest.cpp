#include "base/ProcessTime.h"

#include <chrono>
#include <thread>

#include <doctest/doctest.h>

#ifdef __linux__

#include <sys/resource.h>
#include <sys/syscall.h>

#include "base/TestLoad.h"

using namespace radlab;
using namespace radlab::test;

namespace {

// A process that does something, looked at from its start on and killed in the end.
class Watched {
public:
    explicit Watched(const std::function<void()>& work) : process(forked(work)), time(process) {}
    ~Watched() {
        kill(process, SIGKILL);
        waitpid(process, nullptr, 0);
    }
    Watched(const Watched&) = delete;
    Watched& operator=(const Watched&) = delete;

    /// Looks until this holds; false where it does not within some minutes.
    bool until(const std::function<bool(const ProcessTime&)>& holds) {
        while (!holds(time) && time.seconds() < 300.0) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
            time.look();
        }
        return holds(time);
    }

    /// Stops it, looks a last time, and says how many seconds of processors it took, with the children that it has waited for.
    double took() {
        kill(process, SIGSTOP);
        (void)until([](const ProcessTime& now) { return now.stopped() > 0.0; });
        kill(process, SIGKILL);
        siginfo_t ended{};
        rusage use{};
        syscall(SYS_waitid, P_PID, process, &ended, WEXITED | WNOWAIT, &use);
        const auto seconds = [](const timeval& of) {
            return static_cast<double>(of.tv_sec) + 1e-6 * static_cast<double>(of.tv_usec);
        };
        return seconds(use.ru_utime) + seconds(use.ru_stime);
    }

private:
    pid_t process;

public:
    ProcessTime time;
};

bool usedOneSecond(const ProcessTime& time) { return time.used() > 1.0; }
bool waitedTwoSeconds(const ProcessTime& time) { return time.waited() > 2.0; }

void starve(const BusyProcessor& busy) {
    stayOn(busy.number());
    yieldToAll();
    spin();
}

}  // namespace

TEST_CASE("time: who sleeps and who spins uses time") {
    CHECK(Watched([] { pause(); }).until(usedOneSecond));
    Watched spinning([] { spin(); });
    CHECK(spinning.until(usedOneSecond));
    const double took = spinning.took();
    CHECK(spinning.time.used() > 0.5 * took);
}

TEST_CASE("time: who is ready while others take the processor waits, however it was started") {
    const BusyProcessor busy;
    for (const int generations : {0, 2}) {
        CAPTURE(generations);
        // By another thread, too, which /proc lists apart.
        Watched starved([&] {
            std::function<void(int)> begin = [&](int left) {
                if (left == 0) starve(busy);
                std::thread([&] {
                    (void)forked([&] { begin(left - 1); });
                    pause();
                }).join();
            };
            begin(generations);
        });
        CHECK(starved.until(waitedTwoSeconds));
        CHECK(starved.time.used() < 0.5 * starved.time.waited());
    }
}

TEST_CASE("time: threads that take the processor from each other use time, and wait for nobody") {
    Watched crowd([] {
        stayOn(BusyProcessor::anyOfMine());
        for (int i = 1; i < 40; ++i) std::thread(spin).detach();
        spin();
    });
    CHECK(crowd.until(usedOneSecond));
    const double took = crowd.took();
    CHECK(crowd.time.used() > 0.5 * took);  // all on one processor
}

TEST_CASE("time: what children took that are gone is used, too") {
    Watched parent([] {
        stayOn(BusyProcessor::anyOfMine());
        for (;;) {
            const pid_t child = forked([] {
                volatile unsigned i = 0;
                while (i < 20'000'000) i = i + 1;
            });
            waitpid(child, nullptr, 0);
        }
    });
    CHECK(parent.until(usedOneSecond));
    const double took = parent.took();
    CHECK(parent.time.used() > 0.5 * took);
}

TEST_CASE("time: who is stopped uses nothing") {
    Watched stopped([] { raise(SIGSTOP); });
    CHECK(stopped.until([](const ProcessTime& time) { return time.stopped() > 1.0; }));
    CHECK(stopped.time.used() < 0.5);
}

TEST_CASE("time: who looks late does not blame the process") {
    Watched sleeping([] { pause(); });
    std::this_thread::sleep_for(std::chrono::seconds(3));
    sleeping.time.look();
    CHECK(sleeping.time.used() <= 1.5);
    CHECK(sleeping.time.waited() >= 1.5);
}

TEST_CASE("time: where the system says nothing, a share of it is used") {
    ProcessTime nobody(-1);
    while (nobody.used() + nobody.waited() == 0.0) nobody.look();
    CHECK(nobody.used() == doctest::Approx(nobody.waited() / 3.0));
}

#endif
