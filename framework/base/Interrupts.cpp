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

volatile std::sig_atomic_t came = 0;
volatile std::sig_atomic_t again[sizeof signals / sizeof *signals] = {};

// Calls nothing but what a signal handler may call.
void note(int number) {
    came = 1;
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

}  // namespace

bool doneWhole(const std::function<void()>& work) {
    try {
        work();
        return true;
    } catch (const Interrupted&) {
        return false;
    }
}

Interrupts::Interrupts() {
    came = 0;
    for (int i = 0; i < count; ++i) {
        again[i] = 0;
        before[i] = std::signal(signals[i], note);
        if (before[i] == SIG_IGN) std::signal(signals[i], SIG_IGN);
    }
}

Interrupts::~Interrupts() {
    for (int i = 0; i < count; ++i) std::signal(signals[i], before[i]);
    came = 0;
}

bool Interrupts::caught() { return came != 0; }

void Interrupts::check() {
    if (caught()) throw Interrupted();
}

void Interrupts::forget() {
    for (const int number : signals) {
        const Handler now = std::signal(number, SIG_DFL);
        if (now != note) std::signal(number, now);
    }
}

}  // namespace radlab
