// SPDX-License-Identifier: MIT
// What the runs so far say about runs that have not been made: a Gaussian process for each target over
// the runs that formed a heap, several draws of its hyperparameters, and the probability that a heap
// forms, from all runs. A run without a heap is never dropped: it says where heaps do not form, and the
// powder that was measured formed one.
//   L(x) = P(a heap forms | x) prod_j mean_k N(measured_j; m_jk(x), s_j^2 + v_jk(x))
// j measured targets, k draws, m and v of the process, s of the measurement. It is the expected
// likelihood of a deterministic model with s as its only noise; Jarvenpaa, Gutmann, Vehtari &
// Marttinen (2019), Bayesian Anal. 14, 595, doi:10.1214/18-BA1121, equation for the mean.
#pragma once

#include "calibrate/problem.hpp"
#include "statistics/gaussian_process.hpp"
#include "statistics/probit_process.hpp"

#include <cstdint>
#include <vector>

namespace calibrate {

class Surrogate {
  public:
    // Two runs or more must have formed a heap. The same history and seed give the same surrogate.
    Surrogate(const Problem&, const std::vector<Run>& history, std::uint64_t seed);

    // Points are coded, [points][factors].
    Eigen::VectorXd forms(const Eigen::MatrixXd& points) const;           // [points], probability
    Eigen::VectorXd log_likelihood(const Eigen::MatrixXd& points) const;  // [points]
    // Of the mixture of all draws, without the scatter of a run.
    statistics::Prediction at(std::size_t target, const Eigen::MatrixXd& points) const;

    const std::vector<statistics::GaussianProcess>& draws(std::size_t target) const {
        return draws_.at(target);
    }
    const Problem& problem() const { return problem_; }

    // With a run at `point` (coded) in it that yields what is expected there: for the second run of a
    // batch. "Kriging believer": Ginsbourger, Le Riche & Carraro (2010), doi:10.1007/978-3-642-10701-6_6.
    Surrogate believing(const Eigen::VectorXd& point) const;

  private:
    Problem problem_;
    std::vector<statistics::Data> data_;                           // [targets]
    std::vector<std::vector<statistics::GaussianProcess>> draws_;  // [targets][draws]
    statistics::ProbitProcess forms_;
};

}  // namespace calibrate
