#include "grader/batch/Interrupts.h"

namespace radlab::grader {

namespace {

constexpr int signals[] = {SIGINT, SIGTERM, SIGHUP};

volatile std::sig_atomic_t came = 0;

void note(int) { came = 1; }

}  // namespace

Interrupts::Interrupts() {
    came = 0;
    struct sigaction action {};
    action.sa_handler = note;
    action.sa_flags = SA_RESETHAND | SA_RESTART;
    for (int i = 0; i < 3; ++i) {
        sigaction(signals[i], nullptr, &before[i]);
        if (before[i].sa_handler != SIG_IGN) sigaction(signals[i], &action, nullptr);
    }
}

Interrupts::~Interrupts() {
    for (int i = 0; i < 3; ++i) sigaction(signals[i], &before[i], nullptr);
    came = 0;
}

bool Interrupts::caught() { return came != 0; }

void Interrupts::forget() {
    for (const int number : signals) {
        struct sigaction now {};
        sigaction(number, nullptr, &now);
        if (now.sa_handler == note) signal(number, SIG_DFL);
    }
}

}  // namespace radlab::grader
