#include "viewer/Supervisor.h"

#include <doctest/doctest.h>

#ifdef __linux__

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <utility>

#include "base/Stopwatch.h"
#include "base/TestLoad.h"
#include "base/TestStderr.h"

using namespace radlab;

namespace {

// What the second viewer is told of the first.
std::string toldOf(double hangSeconds, const std::function<void(RunningNow&)>& first) {
    std::cout.flush();
    std::fflush(nullptr);  // or each child writes it once more
    const test::CapturedStderr captured;
    const int code = supervise(hangSeconds, [&](SharedView& shared, const Restart& restart) -> int {
        if (restart.message.empty()) first(shared.running);
        _Exit(7);
    });
    CHECK(code == 7);
    return captured.text();
}

bool says(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

[[noreturn]] void crash() {
    std::signal(SIGSEGV, SIG_DFL);
    std::raise(SIGSEGV);
    std::abort();
}

}  // namespace

TEST_CASE("a crash is a crash, however long it waits for a processor, or is stopped") {
    const auto busy = std::make_unique<test::BusyProcessor>();
    CHECK(says(toldOf(1.0,
                      [&](RunningNow& now) {
                          const RunningMark mark(now, Running::renderPatchIDs);
                          const Stopwatch watch;
                          test::stayOn(busy->number());
                          while (watch.seconds() < 4.0) {
                          }
                          crash();
                      }),
               "view: renderPatchIDs crashed ("));
    CHECK(says(toldOf(0.5,
                      [](RunningNow& now) {
                          const RunningMark mark(now, Running::calcFF);
                          const pid_t viewer = getpid();
                          (void)test::forked([viewer] {
                              sleep(2);
                              kill(viewer, SIGCONT);
                          });
                          std::raise(SIGSTOP);
                          crash();
                      }),
               "view: calcFF crashed ("));
}

TEST_CASE("a function without an end is named, whether it spins, sleeps, or calls another again and again") {
    CHECK(says(toldOf(0.5,
                      [](RunningNow& now) {
                          const RunningMark mark(now, Running::distributeEnergy);
                          test::spin();
                      }),
               "view: distributeEnergy ran for more than 0.5 s without an end"));
    CHECK(says(toldOf(0.5,
                      [](RunningNow& now) {
                          const RunningMark mark(now, Running::maxenergyPatch);
                          for (;;) pause();
                      }),
               "view: maxenergy_patch ran for more than 0.5 s without an end"));
    CHECK(says(toldOf(0.5,
                      [](RunningNow& now) {
                          const RunningMark mark(now, Running::calcFF);
                          for (;;) const RunningMark inner(now, Running::renderPatchIDs);
                      }),
               "view: calcFF ran for more than 0.5 s without an end"));
}

TEST_CASE("what hangs outside of all functions is nobody's fault") {
    CHECK(toldOf(0.2, [](RunningNow& now) {
              { const RunningMark mark(now, Running::calcFF); }
              sleep(1);
          }) == "");
}

#endif
