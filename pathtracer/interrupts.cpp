// SPDX-License-Identifier: Apache-2.0
#include "pathtracer/interrupts.h"

#include <atomic>
#include <csignal>

namespace plumbline::pathtracer {
namespace {

std::atomic<int> received_signal = 0;
static_assert(std::atomic<int>::is_always_lock_free);  // or a signal handler may not set it

void handle(void (*handler)(int), unsigned flags) {
    struct sigaction action = {};
    action.sa_handler = handler;
    action.sa_flags = static_cast<int>(flags);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

}  // namespace

Interrupts::Interrupts() {
    // RESETHAND brings the default action back, so that a second signal is not waited for.
    handle([](int signal) { received_signal = signal; }, SA_RESETHAND | SA_RESTART);
}

Interrupts::~Interrupts() { handle(SIG_DFL, 0); }

int Interrupts::received() { return received_signal; }

}  // namespace plumbline::pathtracer
