// SPDX-License-Identifier: MIT
// Numbers that a publication or a user states about a scaled simulation, held against each other
// and against what follows from the scale map. Every one is optional; a check needs the numbers
// that it compares.
#pragma once

#include "scaling/cost.hpp"

#include <optional>
#include <vector>

namespace scaling {

struct StatedCounts {
    // Of the scaled simulation, wherever said; the first is the one simulated.
    std::vector<double> grains;
    std::optional<double> original_grains;  // that these are said to stand for
    std::optional<Time> time_step;          // of the scaled simulation
    std::optional<Frequency> feed_rate;     // grains per second
    std::optional<Time> settling_time;      // after the last grain was fed
    std::optional<Time> simulated_time;
    std::optional<Time> wall_time;
    // Formed from `grains`; its packing fraction as measured on the powder.
    std::optional<Heap> heap;
};

// scaled: the cost input after scaling, with the fraction of the Rayleigh time that was said to be
// used. Findings:
//   stated_time_step_over_computed          step said / fraction * Rayleigh time
//   stated_grain_counts_apart               largest over smallest count said
//   stated_originals_over_represented       originals said / (grains said * h^3 or 1)
//   stated_time_over_feed_and_settling      simulated time said / (grains / feed rate + settling)
//   implied_speed_over_measured             grains * steps / wall time said / measured speed
//   packing_to_cover_base_over_measured     packing that just fills the cone / the powder's
std::vector<Finding> stated_findings(const StatedCounts&, const CostInput& scaled,
                                     double originals_per_grain);

}  // namespace scaling
