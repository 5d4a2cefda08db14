// SPDX-License-Identifier: MIT
#include "app/interrupt.hpp"

#include <csignal>

namespace app {

namespace {

std::atomic<bool> arrived{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may touch nothing else");

void remember(int signal) {
    arrived = true;
    if (signal == SIGINT) std::signal(SIGINT, SIG_DFL);
}

}  // namespace

const std::atomic<bool>& interrupt_flag() { return arrived; }

void watch_interrupts() {
    std::signal(SIGINT, remember);
    std::signal(SIGTERM, remember);
}

}  // namespace app
