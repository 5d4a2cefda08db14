// SPDX-License-Identifier: MIT
// The bed on our own core.
#pragma once

#include "dem_min/simulation.hpp"
#include "engines/bed.hpp"

#include <atomic>
#include <functional>

namespace bench {

// Nothing was finished that could be told.
struct Interrupted {};

// Called now and then with the share that is done, 0 to 1; throw Interrupted from it to stop.
using Progress = std::function<void(double)>;

dem_min::Simulation simulation_of(const engines::Bed&, int threads);

// So many steps, in portions between which `progress` is called (it may be empty). Wall time
// without those calls, s.
double timed_steps(dem_min::Simulation&, int steps, const Progress& progress);

// Warms up, then times. The same as a peer's deck does.
engines::BedFigures run_ours(const engines::Bed&, int threads, const Progress& progress = {});

}  // namespace bench
