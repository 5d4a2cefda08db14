// SPDX-License-Identifier: MIT
// Powders whose answer is known: angle of repose and bulk density as closed formulas of the parameters,
// with a region where no heap forms and a scatter from seed to seed. Shapes as the field reports them
// (friction saturates, cohesion adds and makes friction act more, a heap slides off a smooth plate);
// the numbers are invented and vary from trial to trial. Shares no code with the roads.
#pragma once

#include "calibrate/problem.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace synthetic {

struct Powder {
    calibrate::Problem problem;  // with the target as it was "measured"
    Eigen::VectorXd truth;       // the parameters of the powder that was measured
    double scatter_deg, scatter_density;
    std::function<double(const Eigen::VectorXd&)> angle_deg, density,
        margin;  // margin > 0: a heap forms

    // What a simulation gives; the same request gives the same.
    calibrate::Run run(const calibrate::Request&) const;
};

// "three" factors on a curved ridge; "five", one of them logarithmic, with an angle that falls again where
// cohesion makes lumps; "seven", those of Niu et al. (2026), Table 4, with four that hardly act.
Powder powder(const std::string& kind, std::uint64_t trial, bool density_measured = false);

}  // namespace synthetic
