// SPDX-License-Identifier: MIT
#include "calibrate/designs.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>
#include <gsl/gsl_qrng.h>

#include <memory>
#include <random>
#include <utility>

namespace calibrate {
namespace {

constexpr int sobol_factors = 40;  // what GSL's table of primitive polynomials reaches

void require_size(const char* design, int runs, int factors, int most_factors) {
    if (runs < 1 || factors < 1 || factors > most_factors) {
        throw scaling::InvalidParameter(scaling::mistake(
            design, fmt::format("{} runs of {} factors", runs, factors),
            fmt::format("must be at least one run of 1 to {} factors", most_factors),
            "state both sizes"));
    }
}

// In [0, 1) from the upper 53 bits: the standard's distributions differ between libraries.
double uniform(std::mt19937_64& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

}  // namespace

Eigen::MatrixXd latin_hypercube(int runs, int factors, std::uint64_t seed) {
    require_size("latin_hypercube", runs, factors, 1000);
    std::mt19937_64 random(seed);
    Eigen::MatrixXd design(runs, factors);
    for (int factor = 0; factor < factors; ++factor) {
        Eigen::VectorXd slices = Eigen::VectorXd::LinSpaced(runs, 0.0, runs - 1.0);
        for (int k = runs - 1; k > 0; --k) {  // Fisher and Yates
            std::swap(slices(k), slices(static_cast<int>(uniform(random) * (k + 1))));
        }
        for (int run = 0; run < runs; ++run) {
            design(run, factor) = -1.0 + 2.0 * (slices(run) + uniform(random)) / runs;
        }
    }
    return design;
}

Eigen::MatrixXd sobol(int runs, int factors) {
    require_size("sobol", runs, factors, sobol_factors);
    const std::unique_ptr<gsl_qrng, decltype(&gsl_qrng_free)> sequence(
        gsl_qrng_alloc(gsl_qrng_sobol, static_cast<unsigned>(factors)), &gsl_qrng_free);
    std::vector<double> point(static_cast<std::size_t>(factors));
    Eigen::MatrixXd design(runs, factors);
    for (int run = 0; run < runs; ++run) {
        gsl_qrng_get(sequence.get(), point.data());
        for (int k = 0; k < factors; ++k) {
            design(run, k) = 2.0 * point[static_cast<std::size_t>(k)] - 1.0;
        }
    }
    return design;
}

}  // namespace calibrate
