// SPDX-License-Identifier: MIT
// Is there a mismatch, and where? Three families of statistics of the whitened residual r of a fit:
//   shapes      what each effect of the catalogue would do at first order, d (projected off the fitted unknowns): d.r/|d|
//   windows     sum r/sqrt(L) and (sum r^2 - L)/sqrt(2 L) over windows of each channel of each recording, all dyadic lengths
//   regimes     the same over rows sorted by a variable of the state (speed, impact speed, ...), all recordings together
// The largest of each family is held against draws under the null: noise as estimated, the refit repeated in each draw (to
// first order: the projection M = 1 - J (J'J + P)^-1 J'). The least of the three p-values is calibrated by the same draws.
#pragma once

#include "diagnose/fit.hpp"
#include "diagnose/verdict.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace diagnose {

// A sum of squares of so many normal numbers as one normal number (Wilson and Hilferty 1931).
double normal_of_squares(double sum, double count);

// One direction in which an effect would move the recordings: unit length, whitened, projected.
struct Shape {
    std::size_t term;  // of the catalogue
    bool two_sided;
    Eigen::VectorXd direction;
};

// Takes the fitted unknowns out of a whitened long vector; Gaussian priors hold them back.
class Projection {
  public:
    Projection(const std::vector<Unknown>&, const Fit&);
    Eigen::VectorXd operator()(const Eigen::VectorXd& white) const;

  private:
    Eigen::MatrixXd jacobian_, gain_;
};

// Shapes of `terms` about a fit of `h`, at strengths that the recordings can just show and at larger ones.
std::vector<Shape> shapes(const Problem&, const Whitener&, const Hypothesised& h, const Fit&,
                          const std::vector<Term>& terms);

struct Mismatch {
    double p_value;
    double p_shapes, p_windows, p_regimes;  // each family's own
};

// `innovations`: standardised residuals to draw from; empty: normal ones.
Mismatch test_of_mismatch(const Problem&, const Whitener&, const Hypothesised& h, const Fit&,
                          const std::vector<Shape>&, const std::vector<double>& innovations,
                          std::uint64_t seed, int draws);

// The shortest interval of each channel's ordinate that holds 80 % of the squares of `white` (whitened mismatch), the
// channel with most squares over all recordings first, and of each channel the recording with most; less than 2 % is left out. `difference`: the mismatch itself, SI.
std::vector<Located> located(const Problem&, const Eigen::VectorXd& white,
                             const Eigen::VectorXd& difference, double p_value);

}  // namespace diagnose
