// SPDX-License-Identifier: MIT
#include "statistics/gaussian_process.hpp"

#include "scaling/errors.hpp"
#include "statistics/hyperparameters.hpp"

#include <Eigen/Cholesky>
#include <catch2/catch.hpp>

#include <cmath>
#include <random>

using namespace statistics;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

Hyperparameters hyper(double inverse_length, double amplitude, double slope, double noise,
                      Index factors = 1) {
    return {VectorXd::Constant(factors, inverse_length), amplitude, slope, noise};
}

MatrixXd uniform(std::mt19937_64& random, Index rows, Index columns) {
    std::uniform_real_distribution<double> u(-1.0, 1.0);
    MatrixXd x(rows, columns);
    for (double& v : x.reshaped()) v = u(random);
    return x;
}

VectorXd normal(std::mt19937_64& random, Index rows) {
    std::normal_distribution<double> n;
    VectorXd x(rows);
    for (double& v : x) v = n(random);
    return x;
}

// Matern 5/2 and squared exponential once more, from their definitions.
double matern(double r) {
    return (1.0 + std::sqrt(5.0) * r + 5.0 * r * r / 3.0) * std::exp(-std::sqrt(5.0) * r);
}
double bell(double r) { return std::exp(-0.5 * r * r); }

// A function drawn from the process: values at `x` without noise.
VectorXd drawn_function(std::mt19937_64& random, const MatrixXd& x, const Hyperparameters& t) {
    const Index n = x.rows();
    MatrixXd k(n, n);
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j) {
            const VectorXd a = x.row(i).transpose().cwiseProduct(t.inverse_length);
            const VectorXd b = x.row(j).transpose().cwiseProduct(t.inverse_length);
            k(i, j) = t.amplitude * t.amplitude * matern((a - b).norm()) +
                      t.slope * t.slope * a.dot(b) + (i == j ? 1e-9 : 0.0);
        }
    const Eigen::LLT<MatrixXd> llt(k);
    return llt.matrixL() * normal(random, n);
}

}  // namespace

// Ordinary kriging of y(0), y(1) by hand: K l + u 1 = k, l1 + l2 = 1. Subtracting the two rows:
// (l1 - l2)(c0 - c1) = k(x) - k(1 - x), c0 with the noise; u from the first row; variance k(0) -
// l.k - u.
TEST_CASE("gaussian process: two points by hand", "[statistics][exact]") {
    const auto [kernel, c] = GENERATE(table<Kernel, double (*)(double)>(
        {{Kernel::matern52, matern}, {Kernel::squared_exponential, bell}}));
    const double x = GENERATE(0.0, 0.3, 0.5, 1.7), noise = GENERATE(1e-5, 0.4);
    const double p = 1.3, v = 4.0;  // inverse length, amplitude^2
    const GaussianProcess g({MatrixXd{{0.0}, {1.0}}, VectorXd{{1.0, 3.0}}}, kernel,
                            hyper(p, 2.0, 0.0, noise));
    const double c0 = v + noise * noise, c1 = v * c(p);
    const double k1 = v * c(p * std::abs(x)), k2 = v * c(p * std::abs(1.0 - x));
    const double l1 = 0.5 * (1.0 + (k1 - k2) / (c0 - c1)), l2 = 1.0 - l1;
    const double u = k1 - l1 * c0 - l2 * c1;
    const Prediction at = g.at(MatrixXd{{x}});
    REQUIRE(at.mean[0] == Approx(l1 * 1.0 + l2 * 3.0).epsilon(1e-9));
    REQUIRE(at.variance[0] == Approx(v - l1 * k1 - l2 * k2 - u).epsilon(1e-9).margin(1e-9));
}

// With a vague mean only y1 - y2 is informative, and it is N(0, 2 (c0 - c1)).
TEST_CASE("gaussian process: the likelihood of two points is that of their difference",
          "[statistics][exact]") {
    const double noise = 0.3, c0 = 1.0 + noise * noise, c1 = matern(0.7), v = 2.0 * (c0 - c1);
    const GaussianProcess g({MatrixXd{{0.0}, {0.7}}, VectorXd{{5.0, 6.5}}}, Kernel::matern52,
                            hyper(1.0, 1.0, 0.0, noise));
    const double expected = -0.5 * 2.25 / v - 0.5 * std::log(2.0 * std::acos(-1.0) * v);
    REQUIRE(g.log_likelihood() == Approx(expected).epsilon(1e-9));
}

TEST_CASE("gaussian process: without noise it passes through every run", "[statistics][limit]") {
    std::mt19937_64 random(3);
    const MatrixXd x = uniform(random, 12, 3);
    const VectorXd y = normal(random, 12);
    const GaussianProcess g({x, y}, Kernel::matern52, hyper(1.0, 1.0, 1.0, 1e-5, 3));
    const Prediction at = g.at(x);
    // Off by noise^2 K^-1 y, K no smaller than about 1e-3 here.
    REQUIRE((at.mean - y).cwiseAbs().maxCoeff() < 1e-6);
    REQUIRE(at.variance.maxCoeff() < 1e-8);
}

TEST_CASE("gaussian process: runs that are all noise, or far away, leave the mean of the runs",
          "[statistics][limit]") {
    const MatrixXd x{{-1.0}, {0.0}, {1.0}};
    const VectorXd y{{1.0, 2.0, 6.0}};
    const GaussianProcess noisy({x, y}, Kernel::matern52, hyper(1.0, 1.0, 0.0, 1e4));
    REQUIRE(noisy.at(MatrixXd{{0.3}}).mean[0] == Approx(3.0).epsilon(1e-6));
    // Runs without correlation: K = I, so m is the mean with variance 1/3, and g has variance 1.
    const GaussianProcess apart({1e3 * x, y}, Kernel::squared_exponential,
                                hyper(1.0, 1.0, 0.0, 1e-6));
    const Prediction far = apart.at(MatrixXd{{5e3}});
    REQUIRE(far.mean[0] == Approx(3.0).epsilon(1e-9));
    REQUIRE(far.variance[0] == Approx(4.0 / 3.0).epsilon(1e-9));
}

TEST_CASE("gaussian process: a plane is carried on beyond the runs", "[statistics][limit]") {
    std::mt19937_64 random(4);
    const MatrixXd x = uniform(random, 8, 2);
    const VectorXd y = (7.0 + 2.0 * x.col(0).array() - 3.0 * x.col(1).array()).matrix();
    // A prior slope of 1e3 pulls no more than (1e-3)^2 relative to 1e6; little is left to bend.
    const GaussianProcess g({x, y}, Kernel::squared_exponential, hyper(1.0, 1e-3, 1e3, 1e-3, 2));
    REQUIRE(g.at(MatrixXd{{3.0, -4.0}}).mean[0] == Approx(25.0).epsilon(1e-3));
}

TEST_CASE("gaussian process: left-one-out values are those of a fit without the run",
          "[statistics][identity]") {
    std::mt19937_64 random(5);
    const MatrixXd x = uniform(random, 9, 2);
    const VectorXd y = normal(random, 9);
    const Hyperparameters t = hyper(0.8, 1.2, 0.7, 0.2, 2);
    const Prediction left = GaussianProcess({x, y}, Kernel::matern52, t).left_one_out();
    for (Index k = 0; k < 9; ++k) {
        Data rest{MatrixXd(8, 2), VectorXd(8)};
        for (Index i = 0, j = 0; i < 9; ++i)
            if (i != k) rest.x.row(j) = x.row(i), rest.y[j++] = y[i];
        const Prediction at = GaussianProcess(rest, Kernel::matern52, t).at(x.row(k));
        CHECK(left.mean[k] == Approx(at.mean[0]).epsilon(1e-8).margin(1e-9));
        CHECK(left.variance[k] == Approx(at.variance[0] + 0.04).epsilon(1e-8));
    }
}

TEST_CASE("gaussian process: covariance has the variance on its diagonal and sees repeats",
          "[statistics][identity]") {
    std::mt19937_64 random(6);
    const MatrixXd x = uniform(random, 7, 2), p = uniform(random, 4, 2);
    const GaussianProcess g({x, normal(random, 7)}, Kernel::matern52, hyper(0.9, 1.0, 0.5, 0.3, 2));
    const MatrixXd c = g.covariance(p, p);
    const VectorXd v = g.at(p).variance;
    for (Index k = 0; k < 4; ++k) REQUIRE(c(k, k) == Approx(v[k]).epsilon(1e-10));
    // One more run at p0 takes c(i, 0)^2 / (c(0, 0) + noise^2) from each variance, whatever it
    // yields: the update of a Gaussian.
    Data more{MatrixXd(8, 2), VectorXd::Zero(8)};
    more.x << x, p.row(0);
    const VectorXd after =
        GaussianProcess(more, Kernel::matern52, g.hyperparameters()).at(p).variance;
    for (Index k = 0; k < 4; ++k)
        REQUIRE(after[k] == Approx(v[k] - c(k, 0) * c(k, 0) / (c(0, 0) + 0.09)).epsilon(1e-8));
}

// Four runs at one place tell what one run with their mean and half the noise tells.
TEST_CASE("gaussian process: a run of half the noise counts as four", "[statistics][identity]") {
    std::mt19937_64 random(12);
    const MatrixXd places = uniform(random, 6, 2);
    const VectorXd other = normal(random, 6), four = normal(random, 4);
    MatrixXd x(9, 2);
    x << places, places.row(5).replicate(3, 1);
    VectorXd y(9), mean = other, factor = VectorXd::Ones(6);
    y << other.head(5), four;
    mean[5] = four.mean(), factor[5] = 0.5;
    const Hyperparameters t = hyper(0.8, 1.1, 0.6, 0.3, 2);
    const GaussianProcess all({x, y}, Kernel::matern52, t),
        one({places, mean, factor}, Kernel::matern52, t);
    const MatrixXd at = uniform(random, 20, 2);
    const Prediction a = all.at(at), b = one.at(at);
    CHECK((a.mean - b.mean).norm() < 1e-9);
    CHECK((a.variance - b.variance).norm() < 1e-9);
    CHECK_THROWS_AS(GaussianProcess({places, mean, VectorXd::Ones(5)}, Kernel::matern52, t),
                    scaling::InvalidParameter);
    factor[2] = 0.0;
    CHECK_THROWS_AS(GaussianProcess({places, mean, factor}, Kernel::matern52, t),
                    scaling::InvalidParameter);
}

TEST_CASE("gaussian process: the gradient is the slope of the likelihood",
          "[statistics][identity]") {
    const Kernel kernel = GENERATE(Kernel::matern52, Kernel::squared_exponential);
    std::mt19937_64 random(7);
    Data data{uniform(random, 10, 2), normal(random, 10)};
    if (GENERATE(false, true)) data.noise_factor = VectorXd::LinSpaced(10, 0.4, 2.0);
    VectorXd logs(5);
    logs << std::log(0.7), std::log(0.3), std::log(1.4), std::log(0.8), std::log(0.25);
    const auto process = [&](const VectorXd& t) {
        return GaussianProcess(
            data, kernel,
            {t.head(2).array().exp(), std::exp(t[2]), std::exp(t[3]), std::exp(t[4])});
    };
    const VectorXd gradient = process(logs).gradient();
    const double step = 1e-5;  // error of a central difference: step^2 and 1e-16/step, both < 1e-9
    for (Index k = 0; k < 5; ++k) {
        VectorXd up = logs, down = logs;
        up[k] += step, down[k] -= step;
        const double slope =
            (process(up).log_likelihood() - process(down).log_likelihood()) / (2.0 * step);
        CHECK(gradient[k] == Approx(slope).epsilon(1e-6).margin(1e-7));
    }
}

// Functions drawn from a process with two factors that act and one that does not, seen at 20 runs
// with noise. 80 functions with 10 points each; points of one function go together, so that the
// standard error of a share of 0.9 lies between 0.011 and 0.034; three of 0.02 are allowed. With
// draws from the posterior of the hyperparameters the intervals of their mixture are tested.
TEST_CASE("gaussian process: nine in ten 90 % intervals hold functions of its own kind",
          "[statistics][simulation]") {
    std::mt19937_64 random(8);
    Hyperparameters truth = hyper(0.6, 1.0, 1.0, 0.1, 3);
    truth.inverse_length[2] = 1e-3;
    int known = 0, estimated = 0, all = 0, idle = 0;
    for (int trial = 0; trial < 80; ++trial) {
        const MatrixXd x = uniform(random, 30, 3);
        const VectorXd f = drawn_function(random, x, truth);
        const Data seen{x.topRows(20), f.head(20) + 0.1 * normal(random, 20)};
        const MatrixXd unseen = x.bottomRows(10);
        const Prediction p = GaussianProcess(seen, Kernel::matern52, truth).at(unseen);
        VectorXd mean = VectorXd::Zero(10), square = VectorXd::Zero(10);
        const auto draws = drawn(seen, Kernel::matern52, {}, 8, 100 + static_cast<unsigned>(trial));
        double dead = 0.0, live = 0.0;
        for (const Hyperparameters& t : draws) {
            const Prediction q = GaussianProcess(seen, Kernel::matern52, t).at(unseen);
            mean += q.mean / 8.0, square += (q.variance + q.mean.cwiseAbs2()) / 8.0;
            dead += t.inverse_length[2], live += t.inverse_length[0];
        }
        const VectorXd variance = square - mean.cwiseAbs2();
        for (Index k = 0; k < 10; ++k, ++all) {
            known += std::abs(f[20 + k] - p.mean[k]) < 1.645 * std::sqrt(p.variance[k]);
            estimated += std::abs(f[20 + k] - mean[k]) < 1.645 * std::sqrt(variance[k]);
        }
        idle += dead < live;
    }
    CHECK(static_cast<double>(known) / all == Approx(0.9).margin(0.06));
    CHECK(static_cast<double>(estimated) / all == Approx(0.9).margin(0.06));
    CHECK(idle >= 72);  // the factor that does nothing is found out nine times in ten
}

TEST_CASE("hyperparameters: many runs give back the noise that was put in; given noise is kept",
          "[statistics][simulation]") {
    std::mt19937_64 random(9);
    const Hyperparameters truth = hyper(0.6, 1.0, 1.0, 0.3, 1);
    const MatrixXd x = uniform(random, 80, 1);
    const Data data{
        x, 50.0 + 4.0 * (drawn_function(random, x, truth) + 0.3 * normal(random, 80)).array()};
    // 80 runs: relative standard error 1/sqrt(160) = 0.08; three are allowed.
    REQUIRE(most_probable(data, Kernel::matern52, {}).noise == Approx(1.2).epsilon(0.24));
    HyperparameterPrior given;
    given.known_noise = 1.7;
    REQUIRE(most_probable(data, Kernel::matern52, given).noise == Approx(1.7).epsilon(1e-12));
    for (const Hyperparameters& t : drawn(data, Kernel::matern52, given, 3, 1))
        REQUIRE(t.noise == Approx(1.7).epsilon(1e-12));
    given.plane = false;
    REQUIRE(most_probable(data, Kernel::matern52, given).slope == 0.0);
}

TEST_CASE("hyperparameters: neither the unit nor the zero of y matters",
          "[statistics][similarity]") {
    std::mt19937_64 random(10);
    const MatrixXd x = uniform(random, 12, 2);
    const VectorXd y = normal(random, 12);
    const auto a = drawn({x, y}, Kernel::matern52, {}, 2, 5);
    const auto b = drawn({x, (1024.0 * y.array()).matrix()}, Kernel::matern52, {}, 2, 5);
    for (int k = 0; k < 2; ++k) {
        CHECK(b[k].noise == Approx(1024.0 * a[k].noise).epsilon(1e-9));
        CHECK(b[k].inverse_length[1] == Approx(a[k].inverse_length[1]).epsilon(1e-9));
    }
}

TEST_CASE("gaussian process: bad input is refused and named", "[statistics][domain]") {
    const Data good{MatrixXd{{0.0}, {1.0}}, VectorXd{{1.0, 3.0}}};
    const Kernel kernel = Kernel::matern52;
    REQUIRE_THROWS_WITH(GaussianProcess({MatrixXd{{0.0}}, good.y}, kernel, hyper(1, 1, 1, 1)),
                        Catch::Contains("data.x"));
    REQUIRE_THROWS_WITH(GaussianProcess(good, kernel, hyper(0, 1, 1, 1)),
                        Catch::Contains("inverse_length"));
    REQUIRE_THROWS_WITH(GaussianProcess(good, kernel, hyper(1, 0, 1, 1)),
                        Catch::Contains("amplitude"));
    REQUIRE_THROWS_WITH(GaussianProcess(good, kernel, hyper(1, 1, 1, 0)), Catch::Contains("noise"));
    REQUIRE_THROWS_AS(most_probable({MatrixXd{{0.0}}, VectorXd{{1.0}}}, kernel, {}),
                      scaling::InvalidParameter);
}
