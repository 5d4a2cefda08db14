// SPDX-License-Identifier: MIT
// A calibration against heaps: the free parameters of a case as factors, what was recorded of its pile as targets, and a run's
// heap as the values of these targets.
#pragma once

#include "calibrate/problem.hpp"
#include "calibrate/profile_target.hpp"
#include "cases/case.hpp"
#include "rigs/angle_of_repose.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace calibrate {

struct PileOptions {
    std::string estimator;      // of rigs::Estimator; empty: the one of the recording
    bool bulk_density = false;  // the case's stated bulk density has to be met as well
};

struct PileProblem {
    Problem
        problem;  // what was recorded of: angle of repose, deg; heights, mm; where the case states it, bulk density, kg/m^3
    std::string experiment;
    std::optional<rigs::Estimator>
        estimator;  // that reads the angle of a simulated heap; nothing: none was recorded
    std::vector<double> angles;      // deg, as recorded
    std::vector<RingHeight> rings;   // of the recorded profile
    std::vector<std::string> notes;  // what was decided here, for the reader of the result
};

// Factors: parameters of the model with a range, in SI; a range of a decade and more is logarithmic. The angle's deviation is that of
// the mean of the recorded angles: their sample standard deviation, or the recording's noise where that is larger, over the root of
// their number. The bulk density, where the case states one, is trusted to 5 %; unasked it is a
// target without a value on bases of 20 grains and more, where heaps have an inside. `protractor`: a simulated heap is read by its silhouette. Throws
// scaling::InvalidInput where nothing is free, neither angle nor profile is recorded, or a single one without its noise.
PileProblem pile_problem(const cases::Case&, const cases::Experiment&, const PileOptions&,
                         std::uint64_t seed);

// The case with these values of its factors, [factors].
cases::Case at_point(const cases::Case&, const Problem&, const Eigen::VectorXd& point);

// The point of the case's own values, those named "NAME=VALUE" by the texts put in their place; [factors]. Throws scaling::InvalidInput.
Eigen::VectorXd stated_point(const cases::Case&, const Problem&,
                             const std::vector<std::string>& instead);

// What a simulated heap looked like; angles in the order of rigs::computed_estimators.
struct HeapSeen {
    bool formed, at_rest;
    std::array<std::optional<double>, rigs::computed_estimators.size()> angles;  // deg
    std::optional<double> packing_fraction;
    std::vector<double> profile_r = {}, profile_z = {};  // m, mean over azimuths
};

// Nothing where no heap formed, or none that all targets could be read from. `density` of the grains, kg/m^3.
std::optional<std::vector<double>> values_of(const PileProblem&, const HeapSeen&, double density);

}  // namespace calibrate
