// SPDX-License-Identifier: MIT
// What a family's heaps look like on average and how they scatter from seed to seed, told by a design of heaps that LAMMPS has poured
// beside the cases. From this the keys say what the oracle could tell: it knows the truth's own engine, means and scatter.
#pragma once

#include "prove/heap_family.hpp"

#include <Eigen/Core>

#include <map>
#include <string>
#include <vector>

namespace prove {

// What is poured for each arrangement: the user's model at five frictions, three seeds each, and every effect that acts among grains at
// three strengths and three frictions.
struct DesignPour {
    std::string effect;  // empty: none
    double strength, friction;
    std::uint64_t seed;
};
std::vector<DesignPour> heap_design(std::uint64_t seed, const HeapFamily&, std::size_t arrangement);

// Of a scan: mean heights in six rings, the two components of the first harmonic along the azimuth, weighted by r, and the roughness
// that is left, m. A heap's seed scatters in each of them much like a normal deviate.
constexpr Eigen::Index ring_count = 6, feature_count = 9;
Eigen::VectorXd heap_features(const Arrangement&, const std::vector<double>& heights);

struct Response {
    Eigen::MatrixXd base;                            // [features, 3]: 1, x, x^2 of x = log friction
    std::map<std::string, Eigen::MatrixXd> effects;  // [features, 4]: t, t^2, t x, t^2 x
    std::map<std::string, double> largest;           // strength at which t = 1
    Eigen::MatrixXd inverse_covariance;              // of one heap: seed scatter, instrument
    double spot_scatter = 0.0;                       // m, of single spots, seed and surface
    // Covariance of the coefficients over that of a heap's scatter: of the base's [3, 3], of base and effect [7, 7]; and the mean of
    // r' S^-1 r over heaps of one kind. 0: the means are known.
    std::map<std::string, Eigen::MatrixXd> uncertain{};
    double scatter = 0.0;
};

// `features` and `heights`: [design], of heaps of this arrangement without instrument noise; its share is added.
Response heap_response(const HeapFamily&, const Arrangement&, const std::vector<DesignPour>&,
                       const std::vector<Eigen::VectorXd>& features,
                       const std::vector<std::vector<double>>& heights);

// The mean of the features.
Eigen::VectorXd mean_features(const Response&, const std::string& effect, double strength,
                              double friction, double azimuth);

// Metres per metre: how the rings' heights fall outwards.
double flank(const Arrangement&, const Eigen::VectorXd& features);

struct Oracle {
    double lambda;        // r' S^-1 r over all fitted heaps, the user's friction refitted
    double refitted;      // that friction
    double d;             // square root of the same for the nearest wrong effect
    std::string nearest;  // its name
};
// `responses`: of the fitted arrangements. What the means themselves are uncertain by adds to r' S^-1 r; on average it is taken off.
Oracle heap_oracle(const HeapFamily&, const std::vector<Response>& responses,
                   const std::string& effect, double strength, double friction, double azimuth);
double heap_lambda(const HeapFamily&, const std::vector<Response>& responses,
                   const std::string& effect, double strength, double friction, double azimuth);

}  // namespace prove
