// SPDX-License-Identifier: MIT
// Gaussian-process regression (kriging) of noisy runs.
//   y = m + g(x) + e,   e ~ N(0, noise^2),   m with a flat prior
//   cov(g(x), g(x')) = amplitude^2 c(r) + slope^2 z . z',   z = inverse_length * x, r = |z - z'|
//   Matern 5/2: c = (1 + sqrt(5) r + 5 r^2/3) exp(-sqrt(5) r);   squared exponential: c = exp(-r^2/2)
//   P = K^-1 - K^-1 1 (1' K^-1 1)^-1 1' K^-1,   K = cov(g, g) + noise^2 I
//   log p(y) = -y' P y/2 - log|K|/2 - log(1' K^-1 1)/2 - (n - 1) log(2 pi)/2
// Rasmussen & Williams (2006), Gaussian Processes for Machine Learning, section 2.7 (equations 2.41
// to 2.45, explicit basis with a vague prior) and 4.2; left-one-out values: y_i - [P y]_i / P_ii
// with variance 1/P_ii, Dubrule (1983), Math. Geol. 15, 687, doi:10.1007/BF01033232.
// Each factor has its own inverse length: one that does nothing gets an inverse length near 0.
// Repeats of a point (other seeds) are further rows with the same x.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace statistics {

enum class Kernel { matern52, squared_exponential };

struct Hyperparameters {
    Eigen::VectorXd inverse_length;  // [factors], per unit of x, > 0
    double amplitude;                // of what is not a plane, unit of y, > 0
    double slope;                    // of the plane, unit of y; 0: constant mean
    double noise;                    // of one run, unit of y, > 0
};

struct Data {
    Eigen::MatrixXd x;  // [runs][factors]
    Eigen::VectorXd y;  // [runs]
    // Of each run's noise, in place of 1 for all, > 0: [runs], or none. A forecast's noise is that of a run with 1.
    Eigen::VectorXd noise_factor{};
};

struct Prediction {
    Eigen::VectorXd mean;      // [points]
    Eigen::VectorXd variance;  // [points]; of g + m, without the noise of a run
};

class GaussianProcess {
  public:
    // Throws scaling::InvalidParameter for fewer than one run, shapes that differ, values that are
    // not finite or hyperparameters out of their domain.
    GaussianProcess(Data, Kernel, Hyperparameters);

    Prediction at(const Eigen::MatrixXd& points) const;  // [points][factors]
    // Posterior covariance of g + m between a [m][factors] and b [k][factors]; shape [m][k].
    Eigen::MatrixXd covariance(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) const;
    // Each run by the others (at the same hyperparameters), variance with the noise of the run.
    Prediction left_one_out() const;
    double log_likelihood() const { return log_likelihood_; }
    // d log p(y) / d log of (inverse_length..., amplitude, slope, noise), [factors + 3].
    Eigen::VectorXd gradient() const;
    const Hyperparameters& hyperparameters() const { return theta_; }

  private:
    Eigen::VectorXd noises() const;  // variance of each run
    Eigen::MatrixXd prior(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) const;

    Data data_;
    Kernel kernel_;
    Hyperparameters theta_;
    Eigen::LLT<Eigen::MatrixXd> k_;
    Eigen::VectorXd k_one_;  // K^-1 1, [runs]
    double one_k_one_;       // 1' K^-1 1
    double mean_;            // of m
    Eigen::VectorXd p_y_;    // P y, [runs]
    double log_likelihood_;
};

}  // namespace statistics
