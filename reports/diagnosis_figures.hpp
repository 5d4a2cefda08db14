// SPDX-License-Identifier: MIT
// What a diagnosis shows in pictures.
#pragma once

#include "diagnose/verdict.hpp"
#include "reports/runs.hpp"

#include <string>
#include <vector>

namespace reports {

// One channel of one experiment, of a force curve one branch.
struct CurveFigures {
    std::string name;  // "drop-1, z (held out)"
    Figure curve;  // recorded as points, simulated before and after as lines, the located interval
    Figure residual;  // recorded minus simulated, before and after, with the noise
};

// In the order of the verdict's curves. Where before and after are the same, one of them is shown.
std::vector<CurveFigures> curve_figures(const diagnose::Verdict&);

// The missing force over the variable that it depends on, with its band.
Figure missing_figure(const diagnose::MissingEstimate&, const std::string& id);

}  // namespace reports
