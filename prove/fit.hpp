// SPDX-License-Identifier: MIT
// What the generator knows of a case when it fits: a world, experiments, unknowns with ranges and priors, the true covariance
// of the noise. Levenberg-Marquardt within ranges (Marquardt 1963, J. SIAM 11, 431), own code.
#pragma once

#include "prove/world.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace prove {

struct Unknown {
    std::string name;
    double World::*in_world = nullptr;  // exactly one of the four is set
    double Setup::*in_setup = nullptr;
    std::vector<Channel> scaled{}, shifted{};
    int experiment = -1;  // of in_setup; -1: all
    double low = 0.0, high = 1.0;
    double mean = 0.0, deviation = 0.0;  // Gaussian prior; deviation 0: uniform
    bool logarithmic = false;            // low > 0
    std::vector<double> starts{};        // where nothing is known; empty: the middle
};

// Values of unknowns put into a world and its experiments.
void put(const std::vector<Unknown>&, const Eigen::VectorXd& theta, World&, std::vector<Setup>&);
double value_of(const Unknown&, const World&, const std::vector<Setup>&);

struct Noise {
    double correlation = 0.0;  // of neighbouring rows, AR(1)
    bool heavy = false;  // Student's t with 4 degrees of freedom, scaled to the standard deviation
};

// Divided by the standard deviation and freed of the correlation, experiment by experiment, channel by channel. A value that
// is no number counts as 0.
Eigen::VectorXd whitened(const std::vector<Setup>&, const Noise&, const Eigen::VectorXd& residual);
// A world that no integrator can follow is `far_off` in all its rows.
constexpr double far_off = 1e9;
Eigen::VectorXd predict(const World&, const std::vector<Setup>&);

struct Fit {
    World world;
    std::vector<Setup> setups;
    Eigen::VectorXd theta;
    double chi2 = 0.0;     // of whitened residual, data only
    double penalty = 0.0;  // of the priors
    double cost() const { return chi2 + penalty; }
    Eigen::VectorXd misfit;  // whitened rows, then one for each prior
    Eigen::MatrixXd slopes;  // of the misfit by theta; at ends of ranges like anywhere else
    Eigen::MatrixXd information() const { return slopes.transpose() * slopes; }
};

// From the values that `world` and `setups` have. `wanted` has the shape of predict(). Ends where a step gains less than
// `tolerance` of the sum of squares.
Fit fit(World world, std::vector<Setup> setups, const std::vector<Unknown>&, const Noise&,
        const Eigen::VectorXd& wanted, int iterations = 20, double tolerance = 1e-5);

// Standard errors from the information; infinite where a direction is not determined. [unknowns]
Eigen::VectorXd standard_errors(const Fit&);

}  // namespace prove
