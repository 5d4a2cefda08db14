// SPDX-License-Identifier: MIT
// The recorded profile of a heap as targets: mean heights in three rings, R/8 to 3R/8, 3R/8 to 5R/8 and 5R/8 to 7R/8 of the
// base's radius R. Nearer the axis few readings stand for the ring; nearer the edge grains hang over it. A simulated heap is
// read at the recorded radii, so that readings need not be even.
#pragma once

#include "calibrate/problem.hpp"
#include "cases/case.hpp"

#include <optional>
#include <string>
#include <vector>

namespace calibrate {

struct RingHeight {
    Target target;          // mm
    std::vector<double> r;  // m, of its recorded readings
};

// Rings that the recording has readings of; of several instants `t` the last. Its deviation: readings less their straight line over
// r, averaged in sectors of 30 deg; their sample standard deviation, or the noise of z where that is larger, over the
// root of the sectors' number. Throws scaling::InvalidInput for one sector without noise; nothing where no profile is recorded.
std::vector<RingHeight> ring_heights(const cases::Case&, const cases::Experiment&);

// The same mean of a simulated profile, mm; a line between its points; r rising, z, m. Nothing without a profile.
std::optional<double> height_in(const RingHeight&, const std::vector<double>& r,
                                const std::vector<double>& z);

}  // namespace calibrate
