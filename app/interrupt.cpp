// SPDX-License-Identifier: MIT
#include "app/interrupt.hpp"

#include <cerrno>
#include <csignal>
#include <string_view>
#include <unistd.h>

namespace app {

namespace {

std::atomic<bool> arrived{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may touch nothing else");

constexpr std::string_view patience =
    "\nsimilitude: stopping, what was done is being put on disk (Ctrl-\\ ends at once)\n";

// A second signal says that somebody waits; it must not cost them the checkpoint.
void remember(int) {
    const int before = errno;
    if (arrived.exchange(true)) {
        [[maybe_unused]] const auto lost = write(STDERR_FILENO, patience.data(), patience.size());
    }
    errno = before;
}

}  // namespace

const std::atomic<bool>& interrupt_flag() { return arrived; }

void watch_interrupts() {
    struct sigaction action {};
    action.sa_handler = remember;
    action.sa_flags = SA_RESTART;  // a write that is under way goes on
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

}  // namespace app
