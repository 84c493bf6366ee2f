#include "base/Interrupts.h"

#include <csignal>

#include "base/WholeFile.h"

namespace radlab {

namespace {

#ifdef _WIN32
constexpr int signals[] = {SIGINT, SIGTERM, SIGBREAK};
#else
constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP};
#endif

volatile std::sig_atomic_t again[sizeof signals / sizeof *signals] = {};

}  // namespace

bool doneWhole(const std::function<void()>& work) {
    try {
        work();
        return true;
    } catch (const Interrupted&) {
        return false;
    }
}

// Calls nothing but what a signal handler may call.
void Interrupts::note(int number) {
    came = true;
    for (std::size_t i = 0; i < sizeof signals / sizeof *signals; ++i) {
        if (signals[i] != number) continue;
        if (!again[i]) {
            again[i] = 1;
            std::signal(number, note);
            return;
        }
    }
    removePartFiles();
    std::signal(number, SIG_DFL);
    std::raise(number);
}

Interrupts::Interrupts() {
    came = answered = false;
    for (int i = 0; i < count; ++i) {
        again[i] = 0;
        before[i] = std::signal(signals[i], note);
        if (before[i] == SIG_IGN) std::signal(signals[i], SIG_IGN);
    }
}

Interrupts::~Interrupts() {
    for (int i = 0; i < count; ++i) std::signal(signals[i], before[i]);
    came = false;
}

void Interrupts::answer() { answered = came.load(); }

void Interrupts::throwUnlessAnswered() {
    if (!answered) throw Interrupted();
}

void Interrupts::forget() {
    came = false;
    for (const int number : signals) {
        const Handler now = std::signal(number, SIG_DFL);
        if (now != note) std::signal(number, now);
    }
}

}  // namespace radlab
