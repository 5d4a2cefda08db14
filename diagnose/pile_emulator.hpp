// SPDX-License-Identifier: MIT
// What the heaps that have been poured say about heaps that have not: a Gaussian process for log(1 + y/knee) of each number of a
// reduced scan over the coordinates of the world (bulk_effects.hpp), and the scatter about it.
#pragma once

#include "statistics/gaussian_process.hpp"

#include <Eigen/Core>

#include <vector>

namespace diagnose {

// Four channels of as many numbers stand one after the other. Which of them move with the world, channel by channel, and which lean
// to one side or to the other across: without a tilt they are 0 on average, and scatter alike.
struct Numbers {
    std::vector<Eigen::Index> moved, lean, across;  // lean and across: ring by ring, of one length
    bool tilted = false;                            // `lean` moves, too: runs are tilted that way
    double knee = 1.0;  // unit of y: numbers that move are >= 0 and scatter by a share of knee + y
};

class PileEmulator {
  public:
    // How numbers bend and scatter. A run's scatter is `noise` times exp(slopes . x): heaps that stick scatter more.
    struct Learned {
        std::vector<statistics::Hyperparameters> hyper{};  // [numbers]; empty: to be found
        Eigen::VectorXd slopes{};                          // [axes]
    };
    // x [runs][axes]; y [runs][numbers]; `learned` is found where it is empty, on so many threads.
    PileEmulator(Eigen::MatrixXd x, Eigen::MatrixXd y, Numbers, Learned, int threads);

    Eigen::VectorXd mean(const Eigen::VectorXd& x) const;  // [numbers]
    // Covariance of a run about the mean, scatter of seeds and error of the emulator in one: of the left-out residuals of the runs
    // whose heaps are most like this one, each over its scatter, times the scatter of those nearest of all. Wide enough for the runs it
    // is known from, each told by the others.
    Eigen::MatrixXd covariance(const Eigen::VectorXd& like) const;
    // Share of that variance which is the emulator's own error, the same for all heaps of one world.
    double share_of_error(const Eigen::VectorXd& like) const;
    const Learned& learned() const { return learned_; }
    Eigen::Index runs() const { return x_.rows(); }

  private:
    void fit(bool anew, int threads);  // with the scatter as it is
    void learn_scatter();              // from what was left out
    Eigen::VectorXd scatter() const { return (x_ * learned_.slopes).array().exp(); }  // [runs]
    std::vector<Eigen::Index> nearest(const Eigen::VectorXd& like, Eigen::Index most) const;
    double stretched(double y) const;

    Eigen::MatrixXd x_, y_;     // numbers that move: stretched
    Eigen::MatrixXd left_out_;  // each run less what the others say of it, likewise
    Numbers numbers_;
    Learned learned_;
    std::vector<int> process_of_;  // [numbers], -1: none
    std::vector<statistics::GaussianProcess> processes_;
};

}  // namespace diagnose
