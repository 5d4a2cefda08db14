// SPDX-License-Identifier: MIT
// Yes or no as a function of x: does a heap form? Gaussian-process classification.
//   P(yes | f) = Phi(f),   f ~ GP(0, bias^2 + slope^2 x . x' + bend^2 exp(-|x - x'|^2 / (2 length^2)))
// by Laplace's approximation: Rasmussen & Williams (2006), algorithms 3.1 and 3.2, equation 3.82;
// averaged over a grid of slope, bend and length by their evidence. x from -1 to +1.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <vector>

namespace statistics {

class ProbitProcess {
  public:
    // x [runs][factors], yes [runs]. Throws scaling::InvalidParameter for no runs or shapes that
    // differ.
    ProbitProcess(const Eigen::MatrixXd& x, const std::vector<bool>& yes);

    Eigen::VectorXd probability(const Eigen::MatrixXd& points) const;  // [points], of yes

    struct Scales {
        double slope, bend, length;
    };

  private:
    struct Fitted {
        Scales scales;
        double weight;                     // share of the evidence
        Eigen::VectorXd gradient, root_w;  // [runs], at the most probable f
        Eigen::LLT<Eigen::MatrixXd> b;     // I + sqrt(W) K sqrt(W)
    };

    static double climb(const Eigen::MatrixXd& k, const Eigen::VectorXd& sign, Fitted&);

    Eigen::MatrixXd x_;
    std::vector<Fitted> fitted_;
};

}  // namespace statistics
