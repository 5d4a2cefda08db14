// SPDX-License-Identifier: MIT
// Another program, run to its end or to its limit.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

namespace app {

struct ChildEnd {
    std::optional<int> exit_code;  // none: a signal ended it
    int signal = 0;                // likewise
    bool out_of_time = false;      // it was killed at its limit
    double cpu_seconds = 0.0;      // of all its threads
    std::string last_words;        // what it wrote to standard error, the last 2000 characters
};

// Runs `words[0]` with the other words as its arguments, no shell between. Its standard output goes nowhere. It is killed once
// it has used `cpu_limit` seconds of processor time, or has lasted ten times as long (it sleeps or waits), or once `stop` is
// true. Throws std::runtime_error where it cannot be started.
ChildEnd run_child(const std::vector<std::string>& words, double cpu_limit,
                   const std::atomic<bool>& stop);

}  // namespace app
