// SPDX-License-Identifier: MIT
// What the heaps that have been poured say about heaps that have not: a Gaussian process for each number of a reduced scan over
// the coordinates of the world (bulk_effects.hpp), and the scatter about it.
#pragma once

#include "statistics/gaussian_process.hpp"

#include <Eigen/Core>

#include <vector>

namespace diagnose {

// Which numbers of a run move with the world, and which lean to one side or to the other across: without a tilt they are 0 on
// average, and scatter alike.
struct Numbers {
    std::vector<Eigen::Index> moved, lean, across;  // lean and across: ring by ring, of one length
    bool tilted = false;                            // `lean` moves, too: runs are tilted that way
};

class PileEmulator {
  public:
    // x [runs][axes]; y [runs][numbers]. `hyper` [numbers], empty: found anew, on so many threads.
    PileEmulator(Eigen::MatrixXd x, Eigen::MatrixXd y, Numbers,
                 std::vector<statistics::Hyperparameters> hyper, int threads);

    Eigen::VectorXd mean(const Eigen::VectorXd& x) const;  // [numbers]
    // Each run less what the others say of it, [runs][numbers].
    const Eigen::MatrixXd& left_out() const { return left_out_; }
    // Covariance of a run about the mean, scatter of seeds and error of the emulator in one: of the left-out residuals of the runs
    // whose heaps are most like this one. Widened for the number of runs that it is known from (Hotelling).
    Eigen::MatrixXd covariance(const Eigen::VectorXd& like) const;
    // Share of that variance which is the emulator's own error, the same for all heaps of one world.
    double share_of_error(const Eigen::VectorXd& like) const;
    const std::vector<statistics::Hyperparameters>& hyperparameters() const { return hyper_; }
    Eigen::Index runs() const { return x_.rows(); }

  private:
    std::vector<Eigen::Index> nearest(const Eigen::VectorXd& like) const;  // runs

    Eigen::MatrixXd x_, y_, left_out_;
    Numbers numbers_;
    std::vector<statistics::Hyperparameters> hyper_;
    std::vector<int> process_of_;  // [numbers], -1: none
    std::vector<statistics::GaussianProcess> processes_;
};

}  // namespace diagnose
