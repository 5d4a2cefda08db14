// SPDX-License-Identifier: MIT
// Figures of a calibration.
#pragma once

#include "calibrate/calibration.hpp"
#include "reports/runs.hpp"

#include <vector>

namespace reports {

// Measured angle and the heaps of fresh seeds, both with 95 %.
Figure confirmation_figure(const calibrate::Calibration&);

// Each factor's interval over its range, 0 to 1. Empty without a surrogate.
Figure range_figure(const calibrate::Calibration&);

// A target along each of the three factors that move it most, the others as in the answer, with all runs; runs without a
// heap lie on the lower edge.
std::vector<Figure> response_figures(const calibrate::Calibration&, std::size_t target);

}  // namespace reports
