// SPDX-License-Identifier: MIT
// Where a mismatch lies, and the shapes that effects would give it.
#pragma once

#include "diagnose/fit.hpp"
#include "diagnose/verdict.hpp"

#include <Eigen/Core>

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

// The shortest interval of each channel's ordinate that holds 80 % of the squares of `white` (whitened mismatch), the
// channel with most squares over all recordings first, and of each channel the recording with most; less than 2 % is left out. Of the
// lean of a heap the half turn on which it is too high. `difference`: the mismatch itself, SI.
std::vector<Located> located(const Problem&, const Eigen::VectorXd& white,
                             const Eigen::VectorXd& difference, double p_value);

}  // namespace diagnose
