// SPDX-License-Identifier: MIT
// A calibration against heaps that has ended: the runs, the road's answer or the point that was given in its place, and what its confirming heaps say.
#pragma once

#include "calibrate/paper_road.hpp"
#include "calibrate/pile_problem.hpp"
#include "calibrate/surrogate_road.hpp"
#include "statistics/intervals.hpp"

#include <optional>
#include <vector>

namespace calibrate {

struct Calibration {
    PileProblem pile;
    std::vector<Run> history;  // of the road
    std::optional<PaperResult> paper;
    std::optional<SurrogateResult> surrogate;
    std::optional<Eigen::VectorXd> given;  // [factors]; no road: one of the three

    std::vector<Run> confirming() const;            // at the answer, with fresh seeds
    std::optional<Eigen::VectorXd> answer() const;  // [factors]; nothing where no heap formed
};

// What confirming heaps say of a target.
struct Confirmation {
    std::size_t heaps;                             // that formed
    double mean;                                   // unit of the target
    std::optional<statistics::Interval> interval;  // 95 %, Student's; nothing for a single heap
    bool agrees;  // their mean is that measured, within 1.96 joint deviations of the two means
};

// Of a measured target; nothing where no confirming heap formed.
std::optional<Confirmation> confirmed(const Calibration&, std::size_t target);

// Where all measured targets are met by the confirming heaps.
bool holds(const Calibration&);

// Where in a factor's range a value lies, 0 to 1; of its logarithm where the factor is logarithmic.
double share_of_range(const Factor&, double value);

// A target along one factor, the others as in the answer, by the surrogate of all runs.
struct Slice {
    std::vector<double> at;               // of the factor, in its unit
    std::vector<double> mean, low, high;  // unit of the target; 95 %
    std::vector<double> forms;            // probability that a heap forms
};

// `points` values from end to end. Nothing where fewer than two heaps formed.
std::optional<Slice> slice(const Calibration&, std::size_t target, std::size_t factor, int points);

}  // namespace calibrate
