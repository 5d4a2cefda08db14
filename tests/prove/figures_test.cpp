// SPDX-License-Identifier: MIT
// How hidden a secret is: figures made by hand against those of the generator.
#include "prove/figures.hpp"

#include "prove/blind_case.hpp"
#include "tests/prove/worlds.hpp"

#include <catch2/catch.hpp>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>

using namespace prove;

namespace {

// One drop, nothing free, noise of 2 mm; the truth is recorded through a lens that is 1 % off.
Skeleton lens(double correlation) {
    Skeleton sk;
    sk.rig = Rig::drop;
    sk.physics = {"gravity", "hertz_mindlin"};
    Setup s = bead(Rig::drop, {Channel::z});
    s.height = 1.0, s.noise = {2e-3}, s.at = evenly(0.0, 0.3, 31);
    sk.stated = sk.truth = {s};
    sk.noise.correlation = correlation;
    return sk;
}

}  // namespace

TEST_CASE("prove: IDR of a 1 % scale error is the error over the noise, row by row", "[prove]") {
    const Skeleton sk = lens(0.0);
    World truth = sk.world;
    truth.scale[0] = 1.01;
    const Mismatch m = mismatch(sk, truth);
    double sum = 0.0;
    for (const double t : sk.stated[0].at)
        sum += std::pow(0.01 * (1.0 - 0.5 * 9.81 * t * t) / 2e-3, 2);
    REQUIRE(m.lambda == Approx(sum).epsilon(1e-9));
    REQUIRE(m.n_eff == Approx(31.0));
    REQUIRE(m.idr == Approx(std::sqrt(sum / 31.0)).epsilon(1e-9));
}

TEST_CASE("prove: correlated noise leaves fewer rows and whitens neighbours", "[prove]") {
    const Skeleton sk = lens(0.5);
    World truth = sk.world;
    truth.offset[0] = 4e-3;
    const Mismatch m = mismatch(sk, truth);
    REQUIRE(m.n_eff == Approx(31.0 / 3.0));
    // A constant of two standard deviations: first row 2, then 2 (1 - 0.5)/sqrt(0.75).
    REQUIRE(m.whitened[0] == Approx(2.0).epsilon(1e-9));
    REQUIRE(m.whitened[7] == Approx(1.0 / std::sqrt(0.75)).epsilon(1e-9));
}

TEST_CASE("prove: a free offset takes the offset, and what is left is what it cannot take",
          "[prove]") {
    const Skeleton sk = lens(0.0);
    World truth = sk.world;
    truth.scale[0] = 1.01;
    Unknown offset{.name = "offset", .shifted = {Channel::z}};
    offset.low = -0.1, offset.high = 0.1;
    const Term term{"measurement_offset", "z", {offset}};
    const std::vector<std::size_t> list{0};
    const Eigen::VectorXd wanted = predict(truth, sk.truth);
    const Fit f = fit_with(sk, {&term}, list, wanted, base_fit(sk, list, wanted));
    const Eigen::VectorXd z = wanted / 1.01;
    REQUIRE(f.theta[0] == Approx(0.01 * z.mean()).epsilon(1e-4));
    REQUIRE(f.chi2 ==
            Approx(0.01 * 0.01 * (z.array() - z.mean()).square().sum() / 4e-6).epsilon(1e-4));
    // Its standard error is that of a mean.
    REQUIRE(standard_errors(f)[0] == Approx(2e-3 / std::sqrt(31.0)).epsilon(1e-6));
}

TEST_CASE("prove: the oracle's power is 5 % for nothing and Gauss' for one degree of freedom",
          "[prove]") {
    REQUIRE(likelihood_ratio_power(0.0, 3) == Approx(0.05).epsilon(1e-9));
    const double root = 2.5, z = gsl_cdf_ugaussian_Pinv(0.975);
    REQUIRE(likelihood_ratio_power(root * root, 1) ==
            Approx(gsl_cdf_ugaussian_P(root - z) + gsl_cdf_ugaussian_P(-root - z)).epsilon(1e-9));
    REQUIRE(likelihood_ratio_power(400.0, 2) == Approx(1.0));
}

TEST_CASE("prove: the shortest interval with 80 % is found wherever the rows stand", "[prove]") {
    const std::vector<double> at{5.0, 0.0, 1.0, 2.0, 3.0, 4.0};
    const std::vector<double> squares{1.0, 0.5, 4.0, 3.0, 1.0, 0.0};
    const Span80 span = shortest_span(at, squares);  // 4 + 3 + 1 of 9.5
    REQUIRE(span.from == 1.0);
    REQUIRE(span.to == 3.0);
}

TEST_CASE("prove: separation is nothing where another term does the same", "[prove]") {
    // One drop without a bounce: a time base k does what gravity over k^2 does, so buoyancy is as good but for what 8 % of an
    // instrument say to it.
    Skeleton sk = lens(0.0);
    sk.stated[0].fluid_density = sk.truth[0].fluid_density = 25.0;
    World truth = sk.world;
    truth.buoyancy = 1.0;
    const Separation near = separation(sk, truth, {"buoyancy"});
    const double k = 1.0 / std::sqrt(1.0 - 25.0 / sk.truth[0].density);
    REQUIRE(near.d == Approx((k - 1.0) / 0.08).epsilon(0.02));
    REQUIRE(mismatch(sk, truth).lambda > 25.0);
}

// Behind a soft spring a curve says how long the grain holds on, and little else: van der Waals' pull at contact may be as large
// as adhesion's. A row more or less that it holds is a step that no slope tells of, and the base line leans on it.
TEST_CASE("prove: adhesion that lets go at a force is not told from a tail that does", "[prove]") {
    for (const double farthest : {40e-6, 62e-6}) {  // the pull-off force ends at 53 um
        Skeleton sk;
        sk.rig = Rig::pull_off;
        sk.physics = {"hertz_mindlin"};
        Setup s = bead(Rig::pull_off, {Channel::force});
        s.diameter = 80e-6, s.preload = 50e-6, s.cantilever_stiffness = 0.6, s.noise = {3e-6};
        s.at = evenly(farthest, -80e-6, 150);
        const std::vector<double> back = evenly(-80e-6, farthest, 150);
        s.at.insert(s.at.end(), back.begin(), back.end());
        s.retract.assign(300, true);
        std::fill_n(s.retract.begin(), 150, false);
        sk.stated = sk.truth = {s};
        sk.truth[0].base_line = 3e-6, sk.truth[0].base_line_slope = 0.02;
        for (const bool slope : {false, true}) {
            Unknown u{.name = slope ? "base_line_slope@one" : "base_line@one"};
            u.in_setup = slope ? &Setup::base_line_slope : &Setup::base_line;
            u.experiment = 0, u.low = slope ? -1.0 : -1e-4, u.high = -u.low;
            u.deviation = 0.3 * u.high;
            sk.nuisances.push_back(u);
        }
        World truth = sk.world;
        truth.work_of_adhesion = 0.17;
        INFO(farthest);
        CHECK(mismatch(sk, truth).lambda > 25.0);
        CHECK(separation(sk, truth, {"adhesion", "capillary_bridge"}).d < 0.2);
    }
}

// A model with nothing free and nothing uncertain: what a wrong term leaves behind is all there is.
TEST_CASE("prove: how far other two are is told where nothing is free, too", "[prove]") {
    Skeleton sk;
    sk.rig = Rig::pull_off;
    sk.physics = {"hertz_mindlin"};
    Setup s = bead(Rig::pull_off, {Channel::force});
    s.diameter = 80e-6, s.preload = 50e-6, s.noise = {1e-7};
    s.at = evenly(20e-6, -0.1e-6, 100);
    s.retract.assign(100, true);
    sk.stated = sk.truth = {s};
    World truth = sk.world;
    truth.work_of_adhesion = 0.05, truth.charge = 5e-12;
    const Separation near = pair_separation(sk, truth, {"adhesion", "electrostatic"});
    CHECK(std::isfinite(near.d));
    CHECK_FALSE(near.effect.empty());
    CHECK(mismatch(sk, truth).lambda > 25.0);
}

// Bounces out of step, pull-offs between others: a fit that takes a neighbour for the truth makes a key tell of a mismatch that
// nobody can see. At the truth only what the priors take of it is left.
TEST_CASE("prove: the user's model is found again wherever in its ranges it is", "[prove]") {
    for (const Rig rig : {Rig::drop, Rig::incline, Rig::impact, Rig::pull_off}) {
        for (std::uint64_t k = 0; k < 12; ++k) {
            Dice dice(23, k, 0);
            Skeleton sk = draw(rig, dice);
            World truth = sk.world;
            for (const Stated& p : sk.parameters)
                if (p.free) truth.*p.place = p.low + dice.uniform(0.1, 0.9) * (p.high - p.low);
            for (std::size_t e = 0; e < sk.truth.size(); ++e) {
                const std::vector<double> y = predict(truth, sk.truth[e]);
                const std::vector<double> ranges = channel_ranges(
                    {sk.truth[e]}, Eigen::Map<const Eigen::VectorXd>(
                                       y.data(), static_cast<Eigen::Index>(y.size())));
                double largest = 1e-9;  // of a channel that hardly changes
                for (const double value : y)
                    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
                sk.truth[e].noise.clear();
                for (const Channel c : sk.truth[e].recorded)
                    sk.truth[e].noise.push_back(
                        0.03 * std::max(ranges[static_cast<std::size_t>(c)], 0.01 * largest));
                sk.stated[e].noise = sk.truth[e].noise;
            }
            const std::vector<std::size_t> fits = with_role(sk, false);
            double priors = 0.0;
            for (const Unknown& n : sk.nuisances)
                if (!sk.truth[static_cast<std::size_t>(n.experiment)].held_out)
                    priors += std::pow((value_of(n, sk.world, sk.truth) - n.mean) / n.deviation, 2);
            const Fit f = base_fit(sk, fits, predict(truth, chosen(sk.truth, fits)));
            INFO(to_string(rig) << " " << k);
            CHECK(f.chi2 + f.penalty <= priors + 1.0);  // a twentieth of what a key counts as seen
        }
    }
}

TEST_CASE("prove: held-out recordings are like the others", "[prove]") {
    for (const Rig rig : {Rig::drop, Rig::impact, Rig::pull_off, Rig::incline}) {
        double sum = 0.0, squares = 0.0;
        int n = 0;
        for (std::uint64_t k = 0; k < 300; ++k) {
            Dice dice(17, k, 0);
            const Skeleton sk = draw(rig, dice);
            const auto condition = [&](const Setup& s) {
                return std::log(rig == Rig::drop      ? s.height
                                : rig == Rig::impact  ? s.speed
                                : rig == Rig::incline ? s.angle
                                                      : s.preload / s.r_star());
            };
            // The first fitted against the first held out: exchangeable, so that the mean difference is nothing.
            const double d =
                condition(sk.stated[with_role(sk, true).front()]) - condition(sk.stated.front());
            sum += d, squares += d * d, ++n;
        }
        const double error = std::sqrt(squares) / n;
        CHECK(std::abs(sum / n) < 4.0 * error);
    }
}

TEST_CASE("prove: nrmse is per cent of the recorded range, mean over channels", "[prove]") {
    Setup s = bead(Rig::drop, {Channel::z, Channel::x});
    s.at = {0.0, 1.0};
    Eigen::VectorXd recorded(4), predicted(4);
    recorded << 0.0, 2.0, 0.0, 10.0;
    predicted << 0.1, 2.1, 0.0, 10.0;
    REQUIRE(mean_nrmse({s}, predicted, recorded) == Approx(0.5 * 5.0));
}
