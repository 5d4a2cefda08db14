// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>

namespace app {

// Set once SIGINT or SIGTERM has arrived. Further ones change nothing, so that impatience does not
// cost the checkpoint; SIGQUIT (Ctrl-\) ends at once. A signal can reach nothing but an object of
// static storage, hence the one flag of the process.
const std::atomic<bool>& interrupt_flag();

void watch_interrupts();

}  // namespace app
