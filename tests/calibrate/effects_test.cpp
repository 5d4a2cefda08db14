// SPDX-License-Identifier: MIT
#include "calibrate/effects.hpp"

#include "calibrate/designs.hpp"
#include "scaling/errors.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace calibrate;

namespace {

// Temperature, concentration and catalyst of Box, Hunter & Hunter's pilot plant (1978, table 10.1;
// 2005, table 5.1), yield in grams, Yates' order.
Trials pilot_plant() {
    return {full_factorial(3), {60.0, 72.0, 54.0, 68.0, 52.0, 83.0, 45.0, 80.0}};
}

}  // namespace

// Effects as printed in the book: T 23, C -5, K 1.5, TC 1.5, TK 10, CK 0, TCK 0.5. The model of
// main effects leaves 8/4 (1.5^2 + 10^2 + 0 + 0.5^2) = 205 on 4 degrees of freedom.
TEST_CASE("effects: the pilot plant's are those of the book", "[calibrate][exact]") {
    const EffectFit fit = fit_effects(pilot_plant());
    REQUIRE(fit.effects.size() == 3);
    CHECK(fit.effects[0].estimate == Approx(23.0).epsilon(1e-12));
    CHECK(fit.effects[1].estimate == Approx(-5.0).epsilon(1e-12));
    CHECK(fit.effects[2].estimate == Approx(1.5).epsilon(1e-12));
    CHECK(fit.constant == Approx(64.25).epsilon(1e-12));
    CHECK(fit.sum_of_squares == Approx(205.0).epsilon(1e-12));
    CHECK(fit.degrees_of_freedom == 4);
    // se = 2 s / sqrt(8), s^2 = 205/4; t_{0.975, 4} = 2.776 of every table.
    const double se = 2.0 * std::sqrt(205.0 / 4.0 / 8.0);
    CHECK(fit.effects[0].standard_error == Approx(se).epsilon(1e-12));
    CHECK(fit.effects[0].interval.high == Approx(23.0 + 2.776 * se).epsilon(2e-4));
    for (const LevelMeans& m : level_means(pilot_plant()))
        CHECK(m.effect ==
              Approx(fit.effects[static_cast<std::size_t>(m.factor[0] - 'A')].estimate));
}

// In an orthogonal two-level design a factor's sum of squares is runs/4 effect^2.
TEST_CASE("effects: the analysis of variance of the pilot plant adds up", "[calibrate][exact]") {
    const AnalysisOfVariance a = analysis_of_variance(pilot_plant());
    CHECK(a.factors[0].sum_of_squares == Approx(2.0 * 23.0 * 23.0).epsilon(1e-10));
    CHECK(a.factors[1].sum_of_squares == Approx(50.0).epsilon(1e-10));
    CHECK(a.factors[2].sum_of_squares == Approx(4.5).epsilon(1e-10));
    CHECK(a.residual.sum_of_squares == Approx(205.0).epsilon(1e-10));
    CHECK(a.total.sum_of_squares == Approx(1058.0 + 50.0 + 4.5 + 205.0).epsilon(1e-10));
    // F of one degree of freedom is t squared.
    const double t = fit_effects(pilot_plant()).effects[0].t;
    CHECK(a.factors[0].f == Approx(t * t).epsilon(1e-10));
    CHECK(a.factors[0].p == Approx(fit_effects(pilot_plant()).effects[0].p).epsilon(1e-10));
}

// Three levels by hand: column means 2, 5, 8 of y = 3 level + {-1, 0, 1}.
TEST_CASE("effects: three levels have two degrees of freedom", "[calibrate][exact]") {
    Trials t{full_factorial(2, 3), {}};
    for (int run = 0; run < 9; ++run)
        t.responses.emplace_back(5.0 + 3.0 * t.design(run, 0) + t.design(run, 1));
    const AnalysisOfVariance a = analysis_of_variance(t);
    CHECK(a.factors[0].degrees_of_freedom == 2);
    CHECK(a.factors[0].sum_of_squares == Approx(54.0).epsilon(1e-10));
    CHECK(a.factors[1].sum_of_squares == Approx(6.0).epsilon(1e-10));
    CHECK(a.residual.sum_of_squares == Approx(0.0).margin(1e-10));
    CHECK(a.residual.degrees_of_freedom == 4);
}

TEST_CASE("effects: a deficient design is refused unless a term is left out",
          "[calibrate][domain]") {
    Trials t{full_factorial(2), {1.0, 2.0, 3.0, 5.0}};
    t.design.conservativeResize(4, 3);
    t.design.col(2) = t.design.col(0);
    CHECK_THROWS_AS(fit_effects(t), scaling::InvalidParameter);
    const EffectFit fit = fit_effects(t, 3);
    CHECK(fit.left_out == "C");
    CHECK(fit.effects.size() == 2);
    t.responses.pop_back();
    CHECK_THROWS_AS(fit_effects(t, 3), scaling::InvalidParameter);
}

// Cohen (1988), Statistical Power Analysis, table 2.4.1: 64 in each of two groups find d = 0.5 at
// 5 %, two-sided, with probability 0.80; se of the difference is sqrt(2/64), 126 degrees of
// freedom. With endless degrees of freedom it is z_0.975 + z_0.8 = 1.95996 + 0.84162.
TEST_CASE("effects: power is that of published tables", "[calibrate][exact]") {
    CHECK(power_of(0.5, std::sqrt(2.0 / 64.0), 126) == Approx(0.80).margin(0.005));
    CHECK(power_of(0.0, 1.0, 10) == Approx(0.05).margin(1e-12));
    CHECK(detectable_effect(1.0, 10000000) == Approx(2.80158).epsilon(1e-4));
    CHECK(power_of(detectable_effect(2.0, 4), 2.0, 4) == Approx(0.8).epsilon(1e-6));
    CHECK_THROWS_AS(power_of(1.0, 1.0, 0), scaling::InvalidParameter);
}
