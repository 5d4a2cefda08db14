// SPDX-License-Identifier: MIT
// The reduced scan of surfaces whose profile, lean and roughness are known.
#include "diagnose/pile_profile.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

using diagnose::Rings;
using diagnose::Scan;

namespace {

constexpr double radius = 0.02,
                 d = 0.002;  // m: six rings of R/6

Scan scan(int azimuths, int spots, const std::function<double(double, double)>& z) {
    Scan s;
    for (int a = 0; a < azimuths; ++a)
        for (int k = 0; k < spots; ++k) {
            s.azimuth.push_back(2.0 * std::numbers::pi * a / azimuths);
            s.r.push_back((k + 0.5) * radius / spots);
            s.z.push_back(z(s.azimuth.back(), s.r.back()));
        }
    return s;
}

}  // namespace

TEST_CASE("a cone that leans has its profile and its lean in every ring",
          "[diagnose][pile_profile]") {
    const Scan s = scan(24, 80, [](double azimuth, double r) {
        return 0.01 - 0.4 * r + 0.1 * r * std::cos(azimuth) - 0.05 * r * std::sin(azimuth);
    });
    const Rings rings(s, radius, d, 1e-6);
    REQUIRE(rings.count() == 6);
    const Eigen::VectorXd y = rings.reduced(s.z, true);
    for (int k = 0; k < 6; ++k) {
        const double r = rings.radius()[static_cast<std::size_t>(k)];
        CHECK(r == Approx((k + 0.5) * radius / 6.0).epsilon(0.03));  // spots are 0.25 mm apart
        // Linear in r but for the product of r and cos, which averages out over the ring.
        CHECK(y[k] == Approx(0.01 - 0.4 * r).epsilon(1e-9));
        CHECK(y[6 + k] == Approx(0.1 * r).epsilon(1e-9));
        CHECK(y[12 + k] == Approx(-0.05 * r).epsilon(1e-9));
    }
}

TEST_CASE("what the instrument adds to the roughness is added to heights without it",
          "[diagnose][pile_profile]") {
    constexpr double noise = 1e-4, rough = 2e-4;  // m
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    const Scan bare =
        scan(48, 160, [&](double, double r) { return 0.01 - 0.4 * r + rough * normal(random); });
    Scan noisy = bare;
    for (double& z : noisy.z) z += noise * normal(random);
    const Rings rings(bare, radius, d, noise);
    const Eigen::VectorXd with = rings.reduced(noisy.z, true),
                          without = rings.reduced(bare.z, false);
    const double expected = std::hypot(noise, rough);
    for (int k = 0; k < 6; ++k) {
        // 1280 spots a ring: 1/sqrt(2 x 1280) = 2 %, five deviations.
        CHECK(with[18 + k] == Approx(expected).epsilon(0.1));
        CHECK(without[18 + k] == Approx(expected).epsilon(0.1));
    }
}

TEST_CASE("one line across a heap tells its profile and no lean", "[diagnose][pile_profile]") {
    const Scan s = scan(2, 80, [](double, double r) { return 0.01 - 0.4 * r; });
    const Rings rings(s, radius, d, 0.0);
    const Eigen::VectorXd y = rings.reduced(s.z, true);
    for (int k = 0; k < 6; ++k) {
        CHECK(std::isfinite(y[k]));
        CHECK(std::isnan(y[6 + k]));
        CHECK(std::isnan(y[18 + k]));  // the noise is not stated
    }
}

// Least squares of white noise: the covariance of the fit against draws of it.
TEST_CASE("the instrument's part of the covariance is that of repeated scans",
          "[diagnose][pile_profile]") {
    constexpr double noise = 1e-4;
    constexpr int draws = 2000;
    const Scan s = scan(12, 40, [](double, double) { return 0.0; });
    const Rings rings(s, radius, d, noise);
    const Eigen::MatrixXd expected = rings.instrument();
    std::mt19937_64 random(2);
    std::normal_distribution<double> normal;
    Eigen::VectorXd squares = Eigen::VectorXd::Zero(18);
    for (int n = 0; n < draws; ++n) {
        std::vector<double> z(s.z.size());
        for (double& v : z) v = noise * normal(random);
        squares += rings.reduced(z, true).head(18).cwiseAbs2() / draws;
    }
    // A variance from 2000 draws is good to sqrt(2/2000) = 3 %; five deviations.
    for (int k = 0; k < 18; ++k) CHECK(squares[k] == Approx(expected(k, k)).epsilon(0.16));
}
