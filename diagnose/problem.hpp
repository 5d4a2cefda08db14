// SPDX-License-Identifier: MIT
// A case as a judge sees it: recordings as one long vector, a forward model for each, and the unknowns of the user's model.
#pragma once

#include "cases/case.hpp"
#include "diagnose/unknowns.hpp"
#include "rigs/forward.hpp"

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace diagnose {

class Piles;

struct Channel {
    std::string name;
    std::vector<double> recorded;         // [rows], SI; NaN where nothing was measured
    double stated_noise = 0.0;            // standard deviation; 0 where the case does not give it
    std::size_t first = 0;                // place in the long vector
    std::optional<double> own_run_rms{};  // of the user's own run minus this tool's (own_run.hpp)
    std::vector<double> own_run_off{};    // the same, [rows]; empty where it is negligible
};

struct Record {
    const cases::Experiment* experiment;
    std::unique_ptr<rigs::ForwardModel> model;
    rigs::Ordinates ordinates;
    std::string ordinate;  // "t", "angle", "separation", "displacement"
    std::vector<Channel> channels;
    // Of all rows, channel by channel, where what one run of the experiment scatters by is known; else empty, and noise.hpp holds.
    Eigen::MatrixXd covariance{};
};

// A pile of which only angles were recorded: numbers that many kinds of physics give. No fit takes them in.
bool is_lone_angle(const cases::Experiment&);

// SI: "m", "N", "rad", "rad/s", "1".
std::string unit_of_channel(const std::string& name);

// One hypothesis: the user's physics, terms added to it, all unknowns.
struct Hypothesised {
    std::vector<const Term*> terms;
    std::vector<Unknown>
        unknowns;              // those of the base model that are not idle, then those of the terms
    std::string name() const;  // "none", "air_drag", "adhesion + tilt"
};

struct Problem {
    const cases::Case* given = nullptr;
    std::vector<Record> records;
    std::size_t size = 0;       // of the long vector
    std::vector<Unknown> base;  // free parameters, nuisances
    rigs::World world;          // the user's, at stated values
    Eigen::VectorXd recorded;   // [size]; NaN where nothing was measured
    const Piles* piles = nullptr;

    Hypothesised hypothesis(std::vector<const Term*> terms) const;
};

// Of the experiments with role `fit` (or, with `held_out`, of the others) that have a recording. The Case must outlive it. `piles`
// answers for piles; without it they are refused.
Problem problem_of(const cases::Case&, bool held_out = false, const Piles* piles = nullptr);

// The long vector that the hypothesis predicts at theta [unknowns], 0 where the rig has no answer. `only` < 0: all records, else
// this one (the rest 0). `rows` [records]: of a recording over time only so many of its first rows are asked for, of any no row
// where 0; empty: all.
Eigen::VectorXd predicted(const Problem&, const Hypothesised&, const Eigen::VectorXd& theta,
                          int only = -1, const std::vector<std::size_t>& rows = {});

// What the term is missing, at its knots.
std::vector<double> missing_at(const Hypothesised&, const Eigen::VectorXd& theta, const Term&);

// The rows of one record in a long vector, 0 elsewhere.
Eigen::VectorXd rows_of(const Problem&, std::size_t record, const Eigen::VectorXd&);

// The world in which `record` runs, for state variables and plots.
rigs::World world_at(const Problem&, const Hypothesised&, const Eigen::VectorXd& theta,
                     const Record&);

}  // namespace diagnose
