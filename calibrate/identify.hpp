// SPDX-License-Identifier: MIT
// Which parameters the measurements fix, which of them trade against each other, and which second
// measurement would fix more.
//   shrinkage   deviation of the posterior over that of the prior (uniform: 1/sqrt(3) in coded units)
//   trades      J = d m_j / d x_i at the answer, in deviations sqrt(s_j^2 + v_j) of the measurement and of the
//               prior. Columns are pivoted by size as long as they exceed 1 (a prior deviation moves the
//               target by more than it is known): those are pinned; each other factor that moves a
//               target is free as long as the pinned ones make up for it, by -J_pinned^-1 J_free
//   offers      targets that every run records and nobody has measured: I = E log [p(t | x) / p(t)], in bits,
//               over x from the posterior and t = N(m(x), s^2 + v(x)); the expected information of Lindley
//               (1956), Ann. Math. Stat. 27, 986, doi:10.1214/aoms/1177728069
#pragma once

#include "calibrate/posterior.hpp"

#include <string>
#include <vector>

namespace calibrate {

struct Fixed {
    std::string factor;
    double shrinkage;  // 1: the measurements say nothing about it
};

struct Trade {
    std::string factor;  // moved by `step`, a tenth of its range, in its units
    double step;
    std::vector<std::string> with;  // pinned factors
    std::vector<double> by;         // what they have to move, in their units
    std::string words;  // "rolling_friction +0.05 is made up by surface_energy -0.012 J/m^2"
};

struct Offer {
    std::string target;
    double bits;                    // expected information about the parameters
    std::vector<double> shrinkage;  // [factors], expected, with that measurement too
    std::string words;
};

struct Identification {
    std::vector<Fixed> factors;  // in their order
    std::vector<Trade> trades;
    std::vector<Offer> offers;  // most bits first
};

// `answer` coded, [factors].
Identification identify(const Surrogate&, const Posterior&, const Eigen::VectorXd& answer);

}  // namespace calibrate
