// SPDX-License-Identifier: MIT
#include "rigs/forward.hpp"
#include "tests/rigs/world_of_glass.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using rigs::Curves;
using rigs::forward_model;
using rigs::World;

namespace {

constexpr double pi = std::numbers::pi, g = normal_gravity, m = glass_mass, radius = glass_radius;
constexpr double degree = pi / 180.0;

Curves run(const Written& conditions, const World& w, const std::vector<double>& t) {
    return forward_model(glass_experiment("incline", conditions))->predict(w, {t, {}});
}

World plane(double mu, double mu_r = -1.0) {
    World w = a_world({"gravity", "hertz_mindlin"}, {{"sliding_friction", mu}});
    if (mu_r >= 0.0)
        w.physics.insert("rolling_resistance"), w.parameters["rolling_friction"] = mu_r;
    return w;
}

}  // namespace

TEST_CASE("a grain set on a plane rolls down at 5/7 g sin", "[rigs][forward][incline][exact]") {
    const Curves c = run({{"angle", "10 deg"}}, plane(0.5), {0.0, 0.5, 1.0});
    const double a = 5.0 / 7.0 * g * std::sin(10.0 * degree);
    REQUIRE(c.at("s")[0] == 0.0);
    REQUIRE(c.at("s")[1] == Approx(0.125 * a).epsilon(1e-12));
    REQUIRE(c.at("spin")[2] == Approx(a / radius).epsilon(1e-12));
}

TEST_CASE("on a steep plane it slides and spins up at its own rate",
          "[rigs][forward][incline][exact]") {
    const double mu = 0.1, angle = 40.0 * degree;  // tan 40 > 7/2 mu
    const Curves c = run({{"angle", "40 deg"}}, plane(mu), {1.0});
    REQUIRE(c.at("s")[0] ==
            Approx(0.5 * g * (std::sin(angle) - mu * std::cos(angle))).epsilon(1e-12));
    REQUIRE(c.at("spin")[0] == Approx(2.5 * mu * g * std::cos(angle) / radius).epsilon(1e-12));
}

// Level: slip ends after 2 v/(7 mu g), 5/7 of the speed is left.
TEST_CASE("sliding ends in rolling with 5/7 of the speed", "[rigs][forward][incline][exact]") {
    const double v = 0.7, mu = 0.2, ends = 2.0 * v / (7.0 * mu * g);
    const Curves c =
        run({{"angle", "0 deg"}, {"speed", "0.7 m/s"}}, plane(mu), {0.5 * ends, ends, ends + 1.0});
    const double half = 0.5 * ends;
    REQUIRE(c.at("s")[0] == Approx((v - 0.5 * mu * g * half) * half).epsilon(1e-12));
    REQUIRE((c.at("s")[2] - c.at("s")[1]) == Approx(5.0 / 7.0 * v).epsilon(1e-12));
    REQUIRE(c.at("spin")[2] == Approx(5.0 / 7.0 * v / radius).epsilon(1e-12));
}

TEST_CASE("rolling resistance takes mu_r cos from sin, and holds on a gentle slope",
          "[rigs][forward][incline][exact]") {
    const double mu_r = 0.02, angle = 5.0 * degree;
    const Curves c = run({{"angle", "5 deg"}}, plane(0.5, mu_r), {1.0});
    REQUIRE(
        c.at("s")[0] ==
        Approx(0.5 * 5.0 / 7.0 * g * (std::sin(angle) - mu_r * std::cos(angle))).epsilon(1e-12));
    const Curves held = run({{"angle", "1 deg"}}, plane(0.5, mu_r), {5.0});  // tan 1 deg < 0.02
    REQUIRE(held.at("s")[0] == 0.0);
    // Thrown up that slope it comes to rest and stays.
    const double up = 5.0 / 7.0 * g * (std::sin(degree) + mu_r * std::cos(degree)), v = 0.1;
    const Curves thrown = run({{"angle", "1 deg"}, {"speed", "-0.1 m/s"}, {"spin", "-50 rad/s"}},
                              plane(0.5, mu_r), {5.0, 6.0});
    REQUIRE(thrown.at("s")[1] == Approx(-0.5 * v * v / up).epsilon(1e-12));
    REQUIRE(thrown.at("spin")[1] == 0.0);
}

TEST_CASE("adhesion, a bridge and a charge press on, and rolling resistance feels it",
          "[rigs][forward][incline][exact]") {
    const double mu_r = 0.02, angle = 5.0 * degree;
    World w = plane(0.5, mu_r);
    double press = m * g * std::cos(angle);
    SECTION("adhesion") {
        w.physics.insert("adhesion"), w.parameters["work_of_adhesion"] = 0.01;
        press += 2.0 * 1.5 * pi * 0.01 * radius;
    }
    SECTION("a bridge") {
        w.physics.insert("capillary_bridge"), w.parameters["surface_tension"] = 0.01,
                                              w.parameters["liquid_volume"] = 1e-12;
        press += 4.0 * pi * 0.01 * radius;
    }
    SECTION("a charge") {
        w.physics.insert("electrostatic"), w.parameters["charge"] = 5e-10;
        press += 25e-20 / (16.0 * pi * 8.8541878128e-12 * radius * radius);
    }
    const Curves c = run({{"angle", "5 deg"}}, w, {1.0});
    const double a = 5.0 / 7.0 * (g * std::sin(angle) - mu_r * press / m);
    REQUIRE(c.at("s")[0] == Approx(0.5 * a).epsilon(1e-9));
}

TEST_CASE("buoyancy and tilt change the weight's part along the plane",
          "[rigs][forward][incline][exact]") {
    World w = plane(0.5);
    w.physics.insert("buoyancy"), w.physics.insert("tilt");
    w.parameters["tilt_angle"] = 0.02, w.stated["surroundings.fluid_density"] = 1000.0;
    const Curves c = run({{"angle", "10 deg"}}, w, {1.0});
    REQUIRE(c.at("s")[0] ==
            Approx(0.5 * 5.0 / 7.0 * 0.6 * g * std::sin(10.0 * degree + 0.02)).epsilon(1e-12));
}

// Level, no friction, no viscosity: v' = -c v^2, s = ln(1 + c v t)/c.
TEST_CASE("drag slows a sliding grain as the square of its speed",
          "[rigs][forward][incline][exact]") {
    World w = plane(0.0);
    w.physics.insert("air_drag");
    w.stated = {{"surroundings.fluid_viscosity", 0.0}, {"surroundings.fluid_density", 100.0}};
    const double c = 0.5 * 0.44 * 100.0 * pi * radius * radius / m, v = 2.0;
    const std::vector<double> t{0.1, 0.5, 2.0};
    const Curves found = run({{"angle", "0 deg"}, {"speed", "2 m/s"}}, w, t);
    for (std::size_t k = 0; k < t.size(); ++k)
        REQUIRE(found.at("s")[k] == Approx(std::log(1.0 + c * v * t[k]) / c).epsilon(1e-8));
}

// v' = 0 on a level plane but for friction: the slip obeys u' = -7/2 g mu(u); t = integral of du/(7/2 g mu(u)), by Simpson.
TEST_CASE("friction that depends on speed ends the slip when its integral says",
          "[rigs][forward][incline][exact]") {
    World w = plane(0.3);
    w.physics.insert("velocity_dependent_friction");
    w.parameters["dynamic_friction"] = 0.1, w.parameters["friction_velocity"] = 0.2;
    const double v = 1.0;
    double ends = 0.0;
    constexpr int n = 2000;
    for (int k = 0; k <= n; ++k) {
        const double u = v * k / n, mu = 0.1 + 0.2 * std::exp(-u / 0.2);
        ends += (k == 0 || k == n ? 1.0 : k % 2 == 1 ? 4.0 : 2.0) / (3.5 * g * mu) * v / n / 3.0;
    }
    const auto model =
        forward_model(glass_experiment("incline", {{"angle", "0 deg"}, {"speed", "1 m/s"}}));
    const auto slip = model->variables(w, {{0.999 * ends, 1.001 * ends}, {}}).at("slip");
    REQUIRE(slip[0] ==
            Approx(0.001 * ends * 3.5 * g * 0.3).epsilon(0.02));  // mu changes by 1 % over the rest
    REQUIRE(slip[1] == 0.0);
}

TEST_CASE("a missing force of one size drives like a slope", "[rigs][forward][incline][exact]") {
    World w = plane(0.5);
    w.missing = {"speed", {-1.0, 1.0}, {0.1 * m * g, 0.1 * m * g}};
    REQUIRE(run({{"angle", "0 deg"}}, w, {1.0}).at("s")[0] ==
            Approx(0.5 * 5.0 / 7.0 * 0.1 * g).epsilon(1e-9));
}

TEST_CASE("every effect moves the channels of an incline", "[rigs][forward][incline][liveness]") {
    using Parameters = std::map<std::string, double>;
    const auto [effect, parameters] = GENERATE(table<std::string, Parameters>({
        {"air_drag", {}},
        {"buoyancy", {}},
        {"adhesion", {{"work_of_adhesion", 0.01}}},
        {"capillary_bridge", {{"surface_tension", 0.01}, {"liquid_volume", 1e-12}}},
        {"electrostatic", {{"charge", 5e-10}}},
        {"rolling_resistance", {{"rolling_friction", 0.01}}},
        {"velocity_dependent_friction", {{"friction_velocity", 0.2}, {"dynamic_friction", 0.1}}},
        {"tilt", {{"tilt_angle", 0.01}}},
    }));
    const cases::Experiment e =
        glass_experiment("incline", {{"angle", "10 deg"}, {"speed", "1 m/s"}});
    REQUIRE(forward_model(e)->effects().count(effect) == 1);
    const World base = plane(0.2);
    World more = base;
    more.physics.insert(effect), more.parameters.insert(parameters.begin(), parameters.end());
    const rigs::Ordinates o{evenly(0.0, 1.0, 50), {}};
    const Curves a = forward_model(e)->predict(base, o), b = forward_model(e)->predict(more, o);
    REQUIRE(largest_difference(a.at("s"), b.at("s")) > 1e-7);
}

// As in the drop: jitter would stay in fourth differences. Half a metre of range.
TEST_CASE("an incline is smooth in its parameters", "[rigs][forward][incline]") {
    const auto name =
        GENERATE(as<std::string>(), "sliding_friction", "rolling_friction", "drag_factor");
    World w = plane(0.2, 0.01);
    w.physics.insert("air_drag"), w.parameters["drag_factor"] = 1.0;
    const auto model = forward_model(glass_experiment(
        "incline", {{"angle", "5 deg"}, {"speed", "0.5 m/s"}, {"spin", "-100 rad/s"}}));
    const double centre = w.parameters.at(name), weight[] = {1.0, -4.0, 6.0, -4.0, 1.0};
    std::vector<double> sum(100, 0.0);
    for (int k = 0; k < 5; ++k) {
        w.parameters[name] = centre * (1.0 + 1e-4 * (k - 2));
        const auto s = model->predict(w, {evenly(0.0, 1.0, 100), {}}).at("s");
        for (std::size_t i = 0; i < s.size(); ++i) sum[i] += weight[k] * s[i] / 16.0;
    }
    for (const double v : sum) REQUIRE(std::abs(v) < 0.5e-7);
}
