// SPDX-License-Identifier: MIT
#include "rigs/drop.hpp"

#include "scaling/errors.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <string>
#include <utility>
#include <vector>

using rigs::DropRecord;
using rigs::DropSetup;
using rigs::run_drop;

namespace {

constexpr double g = 9.81;

// A glass bead of 4 mm on glass; its impacts last some 20 us.
DropSetup bead(double height, double restitution) {
    DropSetup s{};
    s.conditions.height = height;
    rigs::OneGrain& grain = s.grain;
    grain.radius = grain.r_star = 2e-3;
    grain.mass = 2500.0 * 4.0 / 3.0 * 3.14159265358979323846 * 8e-9;
    grain.inertia = 0.4 * grain.mass * 4e-6;
    grain.gravity = g;
    grain.e_star = 3.4e10;
    grain.g_star = 7e9;
    grain.compliant = true;
    grain.stiffness_ratio = 1.0;
    grain.friction.at_rest = 0.2;
    grain.restitution.slow = restitution;
    return s;
}

// Lowest point at `t` of a grain that loses the share 1 - e of its speed in each instantaneous bounce.
double bounced(double height, double e, double t) {
    double speed = std::sqrt(2.0 * g * height), until = speed / g;
    if (t <= until) return height - 0.5 * g * t * t;
    for (double since = until;;) {
        speed *= e;
        const double flight = 2.0 * speed / g;
        if (t <= since + flight) return (speed - 0.5 * g * (t - since)) * (t - since);
        since += flight;
    }
}

std::vector<double> even_times(double end, int count) {
    std::vector<double> times;
    for (int k = 0; k < count; ++k) times.push_back(end * k / (count - 1));
    return times;
}

cases::Value length(const std::string& text) {
    return {.where = "case.json: experiments[0].conditions",
            .kind = cases::Value::Kind::text,
            .written_text = text};
}

// A case with this physics, and one drop of half a metre.
cases::Case case_with(std::vector<std::string> physics) {
    cases::Case c;
    c.path = "case.json";
    c.model.physics = std::move(physics);
    c.model.parameters["restitution"] = {0.7, "1", {}};
    c.model.parameters["work_of_adhesion"] = {0.05, "J/m^2", {}};
    cases::Experiment e;
    e.rig = "drop";
    e.conditions.members = {{"height", length("500 mm")}, {"speed", length("-2 m/s")}};
    e.grain.diameter.value = scaling::in_si<scaling::Length>(4e-3);
    e.grain.density.value = scaling::in_si<scaling::Density>(2500.0);
    e.grain.youngs_modulus.value = scaling::in_si<scaling::Pressure>(6e10);
    e.plate.youngs_modulus = scaling::in_si<scaling::Pressure>(6e10);
    e.surroundings.gravity = scaling::in_si<scaling::Acceleration>(g);
    c.experiments.push_back(e);
    return c;
}

}  // namespace

// Real impacts last 20 us, in which the grain would fly 0.06 mm at 3 m/s: 0.1 mm a bounce, and e is
// met to 1e-4 with 400 steps an impact, which costs 0.2 mm of apex and 0.1 mm of phase.
TEST_CASE("a bouncing grain follows parabolas that shrink by e^2", "[rigs][drop][exact]") {
    const double height = 0.5, e = GENERATE(0.6, 0.9);
    const std::vector<double> times = even_times(1.2, 4001);
    const DropRecord record = run_drop(bead(height, e), times);
    REQUIRE(record.t == times);
    for (std::size_t k = 0; k < times.size(); ++k)
        REQUIRE(record.z[k] == Approx(bounced(height, e, times[k])).margin(5e-4));
}

TEST_CASE("the apex after the k-th bounce is e^(2k) of the height", "[rigs][drop][exact]") {
    const double height = 0.5, e = 0.8;
    const double fall = std::sqrt(2.0 * height / g);
    double apex_time = fall;
    for (int k = 1; k <= 4; ++k) {
        apex_time += (std::pow(e, k) + (k > 1 ? std::pow(e, k - 1) : 0.0)) * fall;
        const DropRecord record = run_drop(bead(height, e), std::vector<double>{apex_time});
        // 2k times the 1e-4 to which e is met, and the flatness of the apex.
        REQUIRE(record.z[0] == Approx(std::pow(e, 2 * k) * height).epsilon(2e-3));
    }
}

// Friction takes mu (1 + e) v_n where it slides throughout: (7/2) mu (1 + e) v_n < v_x.
TEST_CASE("an oblique bounce takes mu (1 + e) of the normal speed from the tangential one",
          "[rigs][drop][exact]") {
    const double height = 0.2, e = 0.8, mu = 0.1, v_x = 4.0;
    DropSetup s = bead(height, e);
    s.grain.friction.at_rest = mu;
    s.conditions.horizontal_speed = v_x;
    const double v_n = std::sqrt(2.0 * g * height), fall = v_n / g;
    const DropRecord record = run_drop(s, {0.5 * fall, fall + 0.1, fall + 0.2});
    REQUIRE(record.x[0] == Approx(v_x * 0.5 * fall).epsilon(1e-12));  // the parabola itself
    const double after = (record.x[2] - record.x[1]) / 0.1;
    REQUIRE(after == Approx(v_x - mu * (1.0 + e) * v_n).epsilon(1e-3));  // e to 1e-4
}

TEST_CASE("a grain with forward spin bounces forward", "[rigs][drop][exact]") {
    const double height = 0.2, e = 0.8, mu = 0.1;
    DropSetup s = bead(height, e);
    s.grain.friction.at_rest = mu;
    s.conditions.spin = GENERATE(2000.0, -2000.0);  // R times it is 4 m/s: slides throughout
    const double v_n = std::sqrt(2.0 * g * height), fall = v_n / g;
    const DropRecord record = run_drop(s, {fall + 0.1, fall + 0.2});
    const double forward = s.conditions.spin > 0.0 ? 1.0 : -1.0;
    REQUIRE((record.x[1] - record.x[0]) / 0.1 ==
            Approx(forward * mu * (1.0 + e) * v_n).epsilon(1e-3));
}

// Thrown up at 2 m/s after half a second in the hand: 2^2/(2 g) higher.
TEST_CASE("a grain is held until its release, and a negative speed throws it up",
          "[rigs][drop][exact]") {
    DropSetup s = bead(0.5, 0.8);
    s.conditions.speed = -2.0;
    s.conditions.release_time = 0.5;
    const DropRecord record = run_drop(s, {0.0, 0.499, 0.5 + 2.0 / g});
    REQUIRE(record.z[0] == 0.5);
    REQUIRE(record.z[1] == 0.5);
    REQUIRE(record.z[2] == Approx(0.5 + 2.0 / g).epsilon(1e-12));
}

// The work of adhesion is such that half of the pull-off work exceeds the energy of the fall.
TEST_CASE("a grain that falls more slowly than the sticking speed stays where it lands",
          "[rigs][drop][limit]") {
    DropSetup s = bead(1e-5, 1.0);
    s.grain.restitution.slow = 0.8;
    s.grain.work_of_adhesion = 50.0;
    const DropRecord record = run_drop(s);
    REQUIRE(record.impacts == 1);
    REQUIRE(record.settled);
    REQUIRE(record.t.size() == 200);
    REQUIRE(record.z.front() == 1e-5);
    REQUIRE(record.z.back() < 0.0);  // adhesion flattens more than weight does
    s.grain.work_of_adhesion = 0.0;
    REQUIRE(run_drop(s).impacts > 1);
}

// 5/7 of the speed: see the exact answers. Sliding ends after 2 v/(7 mu g) = 15 ms.
TEST_CASE("a grain set down sliding ends in steady rolling, which costs no more steps",
          "[rigs][drop][exact]") {
    DropSetup s = bead(0.0, 0.5);
    s.conditions.horizontal_speed = 0.1;
    const DropRecord record = run_drop(s, {0.0, 10.0, 20.0});
    REQUIRE(record.settled);
    REQUIRE(record.settled_at < 0.1);
    REQUIRE((record.x[2] - record.x[1]) / 10.0 == Approx(0.1 * 5.0 / 7.0).epsilon(1e-3));
}

TEST_CASE("rolling resistance stops a rolling grain", "[rigs][drop][limit]") {
    DropSetup s = bead(0.0, 0.5);
    s.conditions.horizontal_speed = 0.1;
    s.grain.rolling_friction = 0.1;
    const DropRecord record = run_drop(s, {1.0, 2.0});
    REQUIRE(record.settled);
    REQUIRE(record.x[1] == Approx(record.x[0]).epsilon(1e-6));
    REQUIRE(record.x[0] > 0.0);
}

// The promise of the case format: a drop of seconds costs milliseconds, whatever the modulus.
TEST_CASE("ten seconds of bouncing cost less than 50 ms", "[rigs][drop][speed]") {
    DropSetup s = bead(0.5, 0.97);
    s.grain.e_star = GENERATE(1e7, 1e11);
    const std::clock_t start = std::clock();
    const DropRecord record = run_drop(s, even_times(10.0, 200));
    const double milliseconds = 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    REQUIRE(record.impacts > 20);
    REQUIRE(milliseconds < 50.0);
}

TEST_CASE("a drop at times that fall, or without end, is refused", "[rigs][drop][domain]") {
    REQUIRE_THROWS_AS(run_drop(bead(0.5, 0.8), {0.2, 0.1}), scaling::InvalidParameter);
    DropSetup afloat = bead(0.5, 0.8);
    afloat.grain.gravity = 0.0;
    REQUIRE_THROWS_AS(run_drop(afloat), scaling::InvalidParameter);
    REQUIRE(run_drop(afloat, std::vector<double>{7.0}).z[0] == 0.5);
}

TEST_CASE("the setup of a drop holds what the case says", "[rigs][drop]") {
    const cases::Case c = case_with({"gravity", "hertz_coulomb", "adhesion"});
    const DropSetup s = rigs::drop_setup(c, c.experiments[0]);
    REQUIRE(s.conditions.height == 0.5);
    REQUIRE(s.conditions.speed == -2.0);
    REQUIRE(s.conditions.horizontal_speed == 0.0);
    REQUIRE(s.grain.radius == 2e-3);
    REQUIRE(s.grain.gravity == g);
    REQUIRE(s.grain.e_star == Approx(3e10).epsilon(1e-12));  // nu = 0: E/2
    REQUIRE(s.grain.restitution.slow == 0.7);
    REQUIRE(s.grain.work_of_adhesion == 0.05);
    REQUIRE_FALSE(s.grain.compliant);
    const cases::Case bare = case_with({"hertz_mindlin"});
    const DropSetup without = rigs::drop_setup(bare, bare.experiments[0]);
    REQUIRE(without.grain.gravity == 0.0);
    REQUIRE(without.grain.work_of_adhesion == 0.0);
    REQUIRE(without.grain.compliant);
}

TEST_CASE("physics that a single grain does not show is refused by name", "[rigs][drop][domain]") {
    const cases::Case c = case_with({"gravity", "hertz_mindlin", "ageing"});
    REQUIRE_THROWS_AS(rigs::drop_setup(c, c.experiments[0]), scaling::InvalidInput);
    REQUIRE_THROWS_WITH(rigs::drop_setup(c, c.experiments[0]), Catch::Contains("ageing"));
}
