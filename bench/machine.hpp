// SPDX-License-Identifier: MIT
// What a number of grain-steps per second belongs to.
#pragma once

#include <string>

namespace bench {

struct Machine {
    std::string processor;     // /proc/cpuinfo; "unknown" where that does not say
    int cores = 0;             // that this process may use
    double memory = 0.0;       // B
    double load_before = 0.0;  // processes that wanted to run in the last minute (getloadavg)
};

Machine this_machine();

// Whether others took more than an eighth of the cores before the start. Ranks that wait for one
// another then lose far more than threads that do not, and no ratio means anything.
bool busy(const Machine&);

// STREAM's triad, a = b + 3 c, over three arrays of `bytes` in all: B/s, 24 B per element (two
// reads, one write; the read that a write may bring along is not counted), the best of several
// passes.
// McCalpin (1995), "Memory bandwidth and machine balance in current high performance computers".
double triad_bandwidth(double bytes, int threads);

}  // namespace bench
