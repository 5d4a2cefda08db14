// SPDX-License-Identifier: MIT
// What the runs say about the hyperparameters of a Gaussian process: their most probable values,
// and draws from their posterior. Few runs leave them open, and a prediction with one guess alone
// is too sure of itself (Rasmussen & Williams 2006, section 5.2; draws: Neal 2003, Ann. Stat. 31,
// 705, doi:10.1214/aos/1056562461, slice sampling one coordinate at a time in the logarithms).
#pragma once

#include "statistics/gaussian_process.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace statistics {

// Log-normal: median, and standard deviation of the natural logarithm.
struct LogNormal {
    double median, spread;
};

// Amplitude, slope and noise are in units of the spread of y; inverse lengths per unit of x, meant
// for x from -1 to +1. The medians say: most factors bend y little, many do nothing, the scatter of
// a run is a tenth of the spread; the spreads leave a factor of ten both ways at two sigma.
struct HyperparameterPrior {
    LogNormal inverse_length{0.25, 1.2};
    LogNormal amplitude{1.5, 0.8};
    LogNormal slope{1.5, 0.8};
    LogNormal noise{0.1, 1.0};
    bool plane = true;                    // false: constant mean, no slope
    std::optional<double> known_noise{};  // unit of y; where given it is not estimated
};

// Maximum a posteriori from several starts (short, middle and long lengths), BFGS. At least 2 runs.
Hyperparameters most_probable(const Data&, Kernel, const HyperparameterPrior&);

// `count` draws from the posterior, from the most probable ones on. The same seed gives the same
// draws.
std::vector<Hyperparameters> drawn(const Data&, Kernel, const HyperparameterPrior&, int count,
                                   std::uint64_t seed);

}  // namespace statistics
