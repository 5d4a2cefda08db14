// SPDX-License-Identifier: MIT
// A calibration: which parameters may be turned, what was measured, and the runs so far. A road is a
// pure function of these: the same history gives the same next run, in whatever order the runs came
// back and however often the campaign was stopped.
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace calibrate {

struct Factor {
    std::string name, unit;
    double low, high;          // in `unit`; the prior is uniform between them
    bool logarithmic = false;  // uniform in the logarithm; then low > 0
};

struct Target {
    std::string name, unit;
    std::optional<double>
        value;  // as measured; nothing: every run records it, nobody has measured it
    double
        standard_deviation;  // of the measured mean, > 0; of such a measurement where there is none
};

// Run k of a campaign has the seed problem.seed + k.
struct Request {
    Eigen::VectorXd point;  // [factors], in their units
    std::uint64_t seed;
    std::string stage;  // what it is for: "screening", "learning"
};

struct Run {  // a request as it was given, and what came of it
    Request request;
    std::optional<std::vector<double>> values;  // [targets]; nothing: no heap formed
};

struct Problem {
    std::vector<Factor> factors;
    std::vector<Target> targets;  // the first has been measured
    std::uint64_t seed = 1;
};

// -1 at the low and +1 at the high end of each factor, [factors].
Eigen::VectorXd coded(const Problem&, const Eigen::VectorXd& point);
Eigen::VectorXd point_of(const Problem&, const Eigen::VectorXd& coded);

// Throw scaling::InvalidParameter, naming what is wrong. A history may hold each seed once.
void check(const Problem&);
void check(const Problem&, const std::vector<Run>& history);

// Run number k, or nothing. Throws scaling::InvalidParameter where it was run at another point than
// `point`: that history is of another campaign.
const Run* find_run(const Problem&, const std::vector<Run>& history, std::size_t number,
                    const Eigen::VectorXd& point);

// Scatter from seed to seed, pooled over all points that were run more than once.
struct Scatter {
    double standard_deviation;  // unit of the target
    int degrees_of_freedom;
};
std::optional<Scatter> scatter(const Problem&, const std::vector<Run>& history, std::size_t target);

}  // namespace calibrate
