// SPDX-License-Identifier: MIT
// Expected values from F(a) and delta(a) of the 1971 paper, evaluated or integrated here, and from
// printed constants.
#include "scaling/jkr_estimates.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace scaling;

namespace {

constexpr double pi = std::numbers::pi;

struct Curve {
    double e, w, r;
    double force(double a) const {
        return 4.0 * e * a * a * a / (3.0 * r) - std::sqrt(8.0 * pi * w * e * a * a * a);
    }
    double overlap(double a) const { return a * a / r - std::sqrt(2.0 * pi * w * a / e); }
};

JkrPair pair(double e, double w, double r) {
    return {w * si::newtons_per_meter, e * si::pascals, r * si::meters};
}

}  // namespace

TEST_CASE("jkr: the zero-load neck carries no force", "[jkr][exact]") {
    const double e = GENERATE(1e6, 7e10), w = 0.05, r = 25e-6;
    const double a0 = pair(e, w, r).zero_load_contact_radius().value();
    REQUIRE(Curve{e, w, r}.force(a0) == Approx(0.0).margin(1e-12 * w * r));  // algebra
}

TEST_CASE("jkr: the pull-off force is 3/2 pi w R*, the deepest tension", "[jkr][exact]") {
    // dF/da = 0 at a0^3 / 4.
    const double e = 8.6e7, w = 0.38, r = 60e-6;
    const double a = pair(e, w, r).zero_load_contact_radius().value() / std::cbrt(4.0);
    REQUIRE(pair(e, w, r).pull_off_force().value() ==
            Approx(-Curve{e, w, r}.force(a)).epsilon(1e-12));
}

TEST_CASE("jkr: the tear-off gap is 1.60877 (w^2 R* / E*^2)^(1/3) and lies on the fold",
          "[jkr][exact]") {
    const double e = 8.6e7, w = 0.38, r = 60e-6;
    const double gap = pair(e, w, r).tear_off_gap().value();
    REQUIRE(gap ==
            Approx(1.60877 * std::cbrt(w * w * r / (e * e))).epsilon(1e-5));  // digits printed
    const double fold = pair(e, w, r).zero_load_contact_radius().value() /
                        std::cbrt(36.0);  // a^3 = pi w R^2 / (8 E)
    REQUIRE(Curve{e, w, r}.overlap(fold) == Approx(-gap).epsilon(1e-12));
}

TEST_CASE("jkr: separating takes 7.0922 (w^5 R*^4 / E*^2)^(1/3)", "[jkr][exact]") {
    const double e = 8.6e7, w = 0.38, r = 60e-6;
    const double expected = 7.0922 * std::cbrt(std::pow(w, 5) * std::pow(r, 4) / (e * e));
    REQUIRE(pair(e, w, r).separation_work().value() ==
            Approx(expected).epsilon(1e-5));  // digits printed
}

TEST_CASE("jkr: the separation work is the area under the tension curve", "[jkr][energy]") {
    const double e = 8.6e7, w = 0.38, r = 60e-6;
    const Curve curve{e, w, r};
    const double touching = std::cbrt(2.0 * pi * w * r * r / e), fold = touching / std::cbrt(16.0);
    const int n = 20000;
    double work = 0.0;
    for (int k = 0; k < n; ++k) {
        const double a = fold + (touching - fold) * k / n,
                     b = fold + (touching - fold) * (k + 1) / n;
        work -= 0.5 * (curve.force(a) + curve.force(b)) * (curve.overlap(b) - curve.overlap(a));
    }
    REQUIRE(pair(e, w, r).separation_work().value() ==
            Approx(work).epsilon(1e-7));  // trapezoids: 1/n^2
}

TEST_CASE("jkr: the overlap under a load solves F(a) = P", "[jkr][exact]") {
    const double e = 8.6e7, w = GENERATE(0.0, 0.02, 0.38), r = 60e-6, load = 4e-7;
    const double overlap = pair(e, w, r).overlap_under(load * si::newtons).value();
    double low = 0.0, high = r;  // bisect the stable branch, where F grows with a
    if (w > 0.0) low = pair(e, w, r).zero_load_contact_radius().value();
    for (int k = 0; k < 200; ++k) {
        const double a = 0.5 * (low + high);
        (Curve{e, w, r}.force(a) < load ? low : high) = a;
    }
    REQUIRE(overlap == Approx(Curve{e, w, r}.overlap(low)).epsilon(1e-9));
}

TEST_CASE("jkr: without adhesion the overlap is that of Hertz", "[jkr][limit]") {
    const double e = 1e8, r = 1e-4, load = 1e-6;
    const double hertz = std::pow(3.0 * load / (4.0 * e * std::sqrt(r)), 2.0 / 3.0);
    REQUIRE(pair(e, 0.0, r).overlap_under(load * si::newtons).value() ==
            Approx(hertz).epsilon(1e-12));
}

TEST_CASE("jkr: softening by s at the sticking speed kept asks for w s^(2/5)",
          "[jkr][similarity]") {
    const Mass m = 2e-8 * si::kilograms;
    const double s = 1e-3;
    const double hard = pair(8e10, 0.2, 60e-6).sticking_speed(m).value();
    const double soft = pair(8e10 * s, 0.2 * std::pow(s, 0.4), 60e-6).sticking_speed(m).value();
    REQUIRE(soft == Approx(hard).epsilon(1e-12));
}

TEST_CASE("hertz: the deepest overlap has spent the kinetic energy, 8/15 E* sqrt(R*) delta^(5/2)",
          "[hertz][energy]") {
    const double e = 8.6e7, r = 60e-6, m = 2e-8, v = 1.13;
    const double overlap = hertz_impact_overlap(m * si::kilograms, v * si::meters_per_second,
                                                e * si::pascals, r * si::meters)
                               .value();
    REQUIRE(8.0 / 15.0 * e * std::sqrt(r) * std::pow(overlap, 2.5) ==
            Approx(0.5 * m * v * v).epsilon(1e-12));
}
