// SPDX-License-Identifier: MIT
// Do heaps that may sleep (simulate --sleep) match heaps that stay awake, and what does sleep save? The user's own pile, over
// seeds, by the tests and margins of scaled heaps. docs/verify.md says what was measured and with which command.
#pragma once

#include "cases/case.hpp"
#include "verify/comparison.hpp"

#include <cstdint>
#include <string>

namespace verify {

// Means over the heaps that may sleep: shares of the grain-steps that were left out, 1, of all and of those until the last
// grain was fed.
struct Saved {
    double whole, while_fed;
};

struct SleepStudy {
    std::string experiment;
    int grains;  // fed to each heap
    Margins margins;
    Comparison comparison;  // "reference": awake; "scaled": may sleep
    Saved saved;
    double seconds = 0.0;
};

// `seeds` heaps a side, no seed on both; regions sleep below rigs::speed_of_rest. Throws scaling::InvalidInput for a pile that
// cannot be simulated.
SleepStudy sleep_study(const cases::Case&, const cases::Experiment&, int seeds,
                       std::uint64_t first_seed, const Campaign&);

}  // namespace verify
