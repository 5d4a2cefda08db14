// SPDX-License-Identifier: MIT
#include "contact/jkr.hpp"

#include "contact/hertz.hpp"
#include "scaling/errors.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace si = boost::units::si;
using contact::Jkr;
using contact::TearOff;
using std::numbers::pi;

namespace {

// Johnson, Kendall & Roberts (1971), Proc. R. Soc. Lond. A 324, 301, with a as the parameter.
struct Paper {
    double e_star, w, r_star;
    double force(double a) const {
        return 4.0 * e_star * a * a * a / (3.0 * r_star) -
               std::sqrt(8.0 * pi * w * e_star * a * a * a);
    }
    double overlap(double a) const { return a * a / r_star - std::sqrt(2.0 * pi * w * a / e_star); }
    // Contact radius under no load, from force(a) = 0.
    double zero_load_radius() const {
        return std::cbrt(9.0 * pi * w * r_star * r_star / (2.0 * e_star));
    }
};

// Zirconia at full and softened stiffness, glass on the scale of a millimetre, gelatine.
Paper any_powder() {
    return GENERATE(Paper{1.1e11, 0.06, 3e-7}, Paper{8.6e7, 0.38, 6e-5}, Paper{3.5e10, 0.05, 5e-4},
                    Paper{1e6, 0.1, 2e-2});
}

Jkr law_of(const Paper& p, TearOff tear_off = TearOff::fold) {
    return Jkr::from(p.e_star * si::pascals, p.w * si::newtons_per_meter, tear_off);
}

}  // namespace

// The law's a(d) must undo the paper's d(a), from just above the fold (a^3 = a0^3/36) to a thousand
// times its radius. 1e-11: next to the fold a last bit in d is some hundred in a.
TEST_CASE("jkr: at the overlap of the paper stand the paper's force and radius",
          "[contact][jkr][exact]") {
    const Paper paper = any_powder();
    const Jkr law = law_of(paper);
    const double scale = law.length_scale(paper.r_star);
    const double fold = paper.zero_load_radius() / std::cbrt(36.0);
    for (double a = 1.002 * fold; a < 1000.0 * fold; a *= 1.07) {
        const contact::NormalState state = law.at(paper.r_star, scale, paper.overlap(a));
        REQUIRE(state.contact_radius == Approx(a).epsilon(1e-11));
        REQUIRE(state.force ==
                Approx(paper.force(a)).epsilon(1e-11).margin(1e-11 * paper.w * paper.r_star));
    }
}

// The 1971 paper's result. By hand: dF/da = 0 at a^3 = a0^3/4. 1e-12: algebra.
TEST_CASE("jkr: deepest tension is 3/2 pi w R*, whatever E*", "[contact][jkr][exact]") {
    const Paper paper = any_powder();
    const Jkr law = law_of(paper);
    const double scale = law.length_scale(paper.r_star);
    const double overlap = paper.overlap(paper.zero_load_radius() / std::cbrt(4.0));
    const double expected = 1.5 * pi * paper.w * paper.r_star;
    const double tension = -law.at(paper.r_star, scale, overlap).force;
    REQUIRE(tension == Approx(expected).epsilon(1e-12));
    REQUIRE(law.pull_off_force(paper.r_star) == Approx(expected).epsilon(1e-15));
    REQUIRE(-law.at(paper.r_star, scale, 0.98 * overlap).force < tension);
    REQUIRE(-law.at(paper.r_star, scale, 1.02 * overlap).force < tension);
}

// By hand: d = 0 at a^3 = 4/9 a0^3 = 2 pi w R*^2/E*; there F = (8/3 - 4) pi w R*. 1e-12: algebra.
TEST_CASE("jkr: at touch 8/9 of the pull-off force pulls", "[contact][jkr][exact]") {
    const Paper paper = any_powder();
    const Jkr law = law_of(paper);
    const double force = law.at(paper.r_star, law.length_scale(paper.r_star), 0.0).force;
    REQUIRE(force == Approx(-8.0 / 9.0 * law.pull_off_force(paper.r_star)).epsilon(1e-12));
}

// By hand: dd/da = 0 at a^3 = a0^3/36 = pi w R*^2/(8 E*); there F = (1/6 - 1) pi w R*. F(d) has a
// vertical tangent: a last bit in d is its root, 1.5e-8, in F, hence 1e-7.
TEST_CASE("jkr: at the fold 5/9 of the pull-off force is left", "[contact][jkr][exact]") {
    const Paper paper = any_powder();
    const Jkr law = law_of(paper);
    const double scale = law.length_scale(paper.r_star);
    const double force =
        law.at(paper.r_star, scale, law.tear_off_overlap(paper.r_star, scale)).force;
    REQUIRE(force == Approx(-5.0 / 9.0 * law.pull_off_force(paper.r_star)).epsilon(1e-7));
}

// By hand from the fold: -(3/4)(pi^2)^(1/3) = -1.60877. Six digits are given.
TEST_CASE("jkr: the contact tears at a gap of 1.60877 (w^2 R*/E*^2)^(1/3)",
          "[contact][jkr][exact]") {
    const Paper p = any_powder();
    const Jkr law = law_of(p);
    const double unit = std::cbrt(p.w * p.w * p.r_star / (p.e_star * p.e_star));
    const double overlap = law.tear_off_overlap(p.r_star, law.length_scale(p.r_star));
    REQUIRE(overlap / unit == Approx(-1.60877).margin(5e-6));
}

// LAMMPS manual, pair_style granular, jkr: the gap (3 pi^2 g^2 R*/(16 E*^2))^(1/3), g = w/2 surface
// energy; and there pulls the whole pull-off force. 1e-12: algebra.
TEST_CASE("jkr: max_tension ends the contact where the dead load would", "[contact][jkr][exact]") {
    const Paper p = any_powder();
    const Jkr law = law_of(p, TearOff::max_tension);
    const double g = 0.5 * p.w, scale = law.length_scale(p.r_star);
    const double gap = std::cbrt(3.0 * pi * pi * g * g * p.r_star / (16.0 * p.e_star * p.e_star));
    const double overlap = law.tear_off_overlap(p.r_star, scale);
    REQUIRE(overlap == Approx(-gap).epsilon(1e-12));
    REQUIRE(law.at(p.r_star, scale, overlap).force ==
            Approx(-law.pull_off_force(p.r_star)).epsilon(1e-12));
}

// Thornton & Ning (1998), Powder Technol. 99, 154, print 7.09; by hand it is
// (pi/2)^(5/3) (2/5 2^(-1/3) + 12/5 2^(1/3)) = 7.0922. Five digits are given.
TEST_CASE("jkr: to part from touch costs 7.0922 (w^5 R*^4/E*^2)^(1/3)", "[contact][jkr][exact]") {
    const Paper p = any_powder();
    const Jkr law = law_of(p);
    const double scale = law.length_scale(p.r_star);
    const double unit = std::cbrt(std::pow(p.w, 5) * std::pow(p.r_star, 4) / (p.e_star * p.e_star));
    const double work = law.energy(p.r_star, scale, law.tear_off_overlap(p.r_star, scale));
    REQUIRE(work / unit == Approx(7.0922).margin(5e-5));
    REQUIRE(law.energy(p.r_star, scale, 0.0) == Approx(0.0).margin(1e-14 * unit));
}

// Simpson's rule over sqrt(a) on the paper's F(a) and d(a): 400 intervals of a polynomial of degree
// 9, error far below 1e-6.
TEST_CASE("jkr: the energy is the work of the paper's force", "[contact][jkr][energy]") {
    const Paper p = any_powder();
    const Jkr law = law_of(p);
    const double a0 = p.zero_load_radius();
    const double from = std::sqrt(a0 / std::cbrt(36.0)),
                 touch = std::sqrt(a0 * std::cbrt(4.0 / 9.0));
    const double to = GENERATE(0.7, 1.7, 4.0) * touch;
    REQUIRE(to > from);
    const int intervals = 400;
    const double h = (to - touch) / intervals;
    double work = 0.0;
    for (int k = 0; k <= intervals; ++k) {
        const double s = touch + h * k, a = s * s;
        const double slope =
            4.0 * s * s * s / p.r_star - std::sqrt(2.0 * pi * p.w / p.e_star);  // dd/ds
        work += p.force(a) * slope * h / 3.0 * (k == 0 || k == intervals ? 1 : k % 2 == 1 ? 4 : 2);
    }
    const double energy = law.energy(p.r_star, law.length_scale(p.r_star), p.overlap(to * to));
    REQUIRE(energy == Approx(work).epsilon(1e-6));
}

// Central difference over 1e-5 of L^2/R*: its error is (1e-5)^2 times a third derivative below 100.
TEST_CASE("jkr: force is the slope of the energy", "[contact][jkr][energy]") {
    const Paper p = any_powder();
    const Jkr law = law_of(p);
    const double scale = law.length_scale(p.r_star), unit = scale * scale / p.r_star;
    const double d = GENERATE(-1.1, -0.4, 0.0, 1.0, 30.0) * unit, half = 1e-5 * unit;
    const double slope =
        (law.energy(p.r_star, scale, d + half) - law.energy(p.r_star, scale, d - half)) /
        (2.0 * half);
    const double force = law.at(p.r_star, scale, d).force;
    REQUIRE(slope == Approx(force).epsilon(1e-7).margin(1e-7 * law.pull_off_force(p.r_star)));
}

// By hand, with D = d R*/L^2: force and energy depart from Hertz by a few D^(-3/2) (the terms in
// D^(-3/4) cancel), less than 1e-9 beyond D = 1e7.
TEST_CASE("jkr: without adhesion it is Hertz", "[contact][jkr][limit]") {
    const contact::Hertz hertz{3e9};
    const Jkr jkr = Jkr::from(3e9 * si::pascals, 1e-15 * si::newtons_per_meter);
    const double r_star = 1e-4, scale = jkr.length_scale(r_star);
    const double overlap = GENERATE(1e-9, 1e-8, 1e-6);
    REQUIRE(overlap * r_star / (scale * scale) > 1e7);
    const contact::NormalState state = jkr.at(r_star, scale, overlap);
    const contact::NormalState limit = hertz.at(r_star, r_star, overlap);
    REQUIRE(state.force == Approx(limit.force).epsilon(1e-9));
    REQUIRE(jkr.energy(r_star, scale, overlap) ==
            Approx(hertz.energy(r_star, r_star, overlap)).epsilon(1e-9));
}

TEST_CASE("jkr: F/(w R*) against d R*/L^2 is one curve for every powder",
          "[contact][jkr][similarity]") {
    const auto reduced_force = [](const Paper& p, double d) {
        const Jkr law = law_of(p);
        const double scale = law.length_scale(p.r_star);
        return law.at(p.r_star, scale, d * scale * scale / p.r_star).force / (p.w * p.r_star);
    };
    const double d = GENERATE(-1.0, -0.3, 0.0, 1.0, 50.0);
    const double one = reduced_force({1e6, 0.02, 1e-3}, d),
                 other = reduced_force({7e10, 0.2, 5e-6}, d);
    REQUIRE(one == Approx(other).epsilon(1e-12).margin(1e-12));
}

TEST_CASE("jkr: nothing is not a number, at the fold, beyond it or far inside",
          "[contact][jkr][domain]") {
    const Paper p = any_powder();
    const Jkr law = law_of(p);
    const double scale = law.length_scale(p.r_star), fold = law.tear_off_overlap(p.r_star, scale);
    for (const double overlap : {fold, 1.5 * fold, std::nextafter(fold, 0.0), -1e6 * fold}) {
        const contact::NormalState state = law.at(p.r_star, scale, overlap);
        REQUIRE(std::isfinite(state.force));
        REQUIRE(state.contact_radius > 0.0);
        REQUIRE(std::isfinite(law.energy(p.r_star, scale, overlap)));
    }
}
