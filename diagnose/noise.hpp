// SPDX-License-Identifier: MIT
// Noise of recordings: a standard deviation and the correlation of neighbouring rows, first-order autoregressive (AR(1)), for
// each channel of each recording. A residual is whitened row by row,
//   z_k = (r_k - phi r_prev)/(sigma sqrt(1 - phi^2)),   phi = rho^(rows between),
// so that under the right model z is white with deviation 1. Missing rows give z = 0. A recording with a covariance of its own (a
// heap) is whitened by the inverse of its Cholesky factor.
#pragma once

#include "diagnose/problem.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <vector>

namespace diagnose {

struct ChannelNoise {
    double deviation;    // SI, of the channel
    double correlation;  // rho, 0 <= rho < 1
};

using Noise = std::vector<std::vector<ChannelNoise>>;  // [records][channels]

class Whitener {
  public:
    Whitener(const Problem&, const Noise&);

    Eigen::VectorXd operator()(
        const Eigen::VectorXd& residual) const;                    // long vector to long vector
    Eigen::VectorXd coloured(const Eigen::VectorXd& white) const;  // the inverse
    const std::vector<bool>& measured() const { return measured_; }
    std::size_t rows() const { return rows_; }  // measured
    double log_normaliser() const {
        return log_norm_;
    }  // -sum log(sigma sqrt(1 - phi^2)) - rows/2 log(2 pi)

  private:
    void add_block(const Record&);

    std::vector<int> previous_;  // [size], -1: first of its series
    std::vector<double> a_, b_;  // z = a r - b r_previous
    std::vector<bool> measured_;
    struct Block {  // a recording with a covariance
        std::vector<Eigen::Index> rows;
        Eigen::LLT<Eigen::MatrixXd> factor;
    };
    std::vector<Block> blocks_;
    std::size_t rows_ = 0;
    double log_norm_ = 0.0;
};

// Stated deviations, 2 % of a channel's range where none is stated; no correlation.
Noise first_guess(const Problem&);

// From the residual of a model that explains the recordings: correlations, pooled over the recordings of a channel, and the
// deviations that are not stated. The lowest sixteenth of the frequencies is not used (Whittle's likelihood of the
// discrete cosine transform), where a smooth mismatch that is still there would show. `fitted`: number of parameters that
// were fitted, for the deviations of short recordings.
Noise estimated(const Problem&, const Eigen::VectorXd& residual, std::size_t fitted);

}  // namespace diagnose
