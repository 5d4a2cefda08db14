// SPDX-License-Identifier: MIT
// A calibration against heaps: the runs that a road asks for, poured side by side, each remembered as soon as it has ended.
#pragma once

#include "app/heaps_engine.hpp"
#include "calibrate/calibration.hpp"
#include "cases/case.hpp"

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace app {

struct RoadOptions {
    std::string experiment{};                     // empty: the first pile with a recording
    std::string road = "surrogate", estimator{};  // estimator empty: the recording's
    bool bulk_density = false;
    int budget = 34;  // heaps of the surrogate's road; the paper's road pours those that it has
    int batch =
        2;  // of these are decided on together; not the number of threads: that changes no result
    int confirm = 6;                // heaps of fresh seeds at the answer, on top
    std::vector<std::string> at{};  // NAME=VALUE: no road, heaps at this point
    std::string friction_cap{};     // in place of the model's; empty: the model's
    HeapsEngine heaps{};
    std::uint64_t seed = 1;
    int threads = 1;              // heaps at a time
    std::filesystem::path out{};  // for runs.csv and finished heaps; empty: nothing is kept
    bool resume = false, yes = false;
};

struct CalibrationWatch {
    // Heaps poured, of how many at most, and the heap that has just ended (or empty); called from one thread at a time.
    std::function<void(double done, double of, const std::string& ended)> progress;
    const std::atomic<bool>* stop = nullptr;
};

// Throws scaling::InvalidInput, for more than 12 hours too unless `yes`; verify::Interrupted after `stop`.
calibrate::Calibration calibration(const cases::Case&, const RoadOptions&, const CalibrationWatch&);

}  // namespace app
