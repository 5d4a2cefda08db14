// SPDX-License-Identifier: MIT
// A design and what came of its runs. A run that failed is information of its own (no heap formed)
// and is kept as such.
#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace calibrate {

struct Trials {
    Eigen::MatrixXd design;                        // coded, shape [runs][factors]
    std::vector<std::optional<double>> responses;  // [runs]; none: the run failed
};

// Rows of the runs that gave a response, and of those that failed; in their order.
Trials usable(const Trials&);
Eigen::MatrixXd failed_design(const Trials&);

// Of trials none of which failed. Shape [runs].
Eigen::VectorXd responses_of(const Trials&);

// "1", "A", "B" ... : the terms of a linear model of so many factors. Shape [1 + factors].
std::vector<std::string> linear_terms(int factors);

// Throws scaling::InvalidParameter unless design and responses have the same number of runs and
// every number is finite.
void check(const Trials&);

}  // namespace calibrate
