// SPDX-License-Identifier: MIT
#include "contact/jkr.hpp"
#include "dem_min/simulation.hpp"
#include "rigs/forward.hpp"
#include "rigs/physics.hpp"
#include "scaling/errors.hpp"
#include "tests/rigs/world_of_glass.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <thread>

using rigs::Curves;
using rigs::forward_model;
using rigs::World;

namespace {

constexpr double pi = std::numbers::pi, g = normal_gravity, m = glass_mass, radius = glass_radius;

std::vector<double> z_of(const Written& conditions, const World& world,
                         const std::vector<double>& t) {
    return forward_model(glass_experiment("drop", conditions))->predict(world, {t, {}}).at("z");
}

std::vector<double> of(const char* name, const cases::Experiment& e, const World& world,
                       const std::vector<double>& t) {
    const auto model = forward_model(e);
    const Curves channels = model->predict(world, {t, {}}),
                 state = model->variables(world, {t, {}});
    return channels.count(name) > 0 ? channels.at(name) : state.at(name);
}

World bouncing(double e) {
    return a_world({"gravity", "hertz_mindlin"}, {{"restitution", e}, {"sliding_friction", 0.3}});
}

World with(World w, const std::string& effect, std::map<std::string, double> parameters) {
    w.physics.insert(effect);
    for (const auto& [name, value] : parameters) w.parameters[name] = value;
    return w;
}

cases::Experiment in_fluid(cases::Experiment e, double density, double viscosity) {
    e.surroundings.fluid_density = scaling::in_si<scaling::Density>(density);
    e.surroundings.fluid_viscosity = scaling::in_si<scaling::Viscosity>(viscosity);
    return e;
}

}  // namespace

// The rebound is e by definition: algebra.
TEST_CASE("each impact is slower by e than the one before", "[rigs][forward][drop][exact]") {
    const double e = GENERATE(0.3, 0.6, 0.95);
    const auto v = of("impact_speed", glass_experiment("drop", {{"height", "200 mm"}}), bouncing(e),
                      evenly(0.0, 1.0, 2000));
    REQUIRE(v.front() == 0.0);
    double last = 0.0;
    for (const double speed : v) {
        if (speed == last) continue;
        if (last > 0.0 && last < 0.1) break;  // flights shorter than a few rows
        if (last == 0.0)
            REQUIRE(speed == Approx(std::sqrt(2.0 * g * 0.2)).epsilon(1e-12));
        else
            REQUIRE(speed == Approx(e * last).epsilon(1e-12));
        last = speed;
    }
}

// Johnson (1985), eq. 11.24: 2.87 (m^2/(R E*^2 v))^(1/5), three digits.
TEST_CASE("a perfect bounce takes the time of a Hertz impact", "[rigs][forward][drop][exact]") {
    const double v = std::sqrt(2.0 * g * 0.2), fall = v / g,
                 e_star = 0.5 * 6e10 / (1.0 - 0.22 * 0.22);
    const double impact = 2.87 * std::pow(m * m / (radius * e_star * e_star * v), 0.2);
    const auto z = z_of({{"height", "200 mm"}}, bouncing(1.0),
                        {fall, fall + 0.5 * impact, fall + 1.05 * impact});
    REQUIRE(z[0] == Approx(0.0).margin(1e-12));
    // Deepest at half time: (5 m v^2/(4 sqrt(R) E* 4/3))^(2/5), eq. 11.23.
    const double deep = std::pow(15.0 * m * v * v / (16.0 * std::sqrt(radius) * e_star), 0.4);
    REQUIRE(z[1] == Approx(-deep).epsilon(1e-3));
    REQUIRE(z[2] == Approx(0.05 * impact * v).epsilon(0.02));  // three digits of 2.87
}

// Without viscosity Re is infinite and Cd = 0.44 k: z falls by (m/c) ln cosh(t sqrt(g c/m)), c = Cd rho pi R^2/2.
TEST_CASE("quadratic drag from rest is a logarithm of a cosine", "[rigs][forward][drop][exact]") {
    const double factor = 1.7, density = 50.0;
    const cases::Experiment e =
        in_fluid(glass_experiment("drop", {{"height", "20 m"}}), density, 0.0);
    const World w = with(bouncing(0.5), "air_drag", {{"drag_factor", factor}});
    const double c = 0.5 * 0.44 * factor * density * pi * radius * radius;
    const std::vector<double> t = evenly(0.1, 1.8, 18);
    const std::vector<double> z = of("z", e, w, t);
    for (std::size_t k = 0; k < t.size(); ++k)
        REQUIRE(
            z[k] ==
            Approx(20.0 - m / c * std::log(std::cosh(t[k] * std::sqrt(g * c / m)))).epsilon(1e-8));
}

// Re = 1e-6: 0.15 Re^0.687 is 1e-5.
TEST_CASE("in a thick fluid the grain sinks at Stokes' speed", "[rigs][forward][drop][exact]") {
    const double viscosity = 1e3;
    const cases::Experiment e =
        in_fluid(glass_experiment("drop", {{"height", "1 m"}}), 1000.0, viscosity);
    const World w = with(with(bouncing(0.5), "air_drag", {}), "buoyancy", {});
    const double speed = of("speed", e, w, {50.0})[0];
    REQUIRE(speed == Approx(m * g * 0.6 / (6.0 * pi * viscosity * radius)).epsilon(2e-5));
}

TEST_CASE("drag balances weight at the terminal speed, through the whole curve",
          "[rigs][forward][drop][exact]") {
    const double factor = GENERATE(0.5, 1.0, 2.5);
    cases::Experiment e = glass_experiment("drop", {{"height", "500 m"}});
    const World w = with(bouncing(0.5), "air_drag", {{"drag_factor", factor}});
    const double v = of("speed", e, w, {20.0})[0];
    const double re = 1.2 * v * 2.0 * radius / 1.8e-5;
    REQUIRE(re > 1000.0);
    REQUIRE(0.5 * 1.2 * 0.44 * factor * pi * radius * radius * v * v ==
            Approx(m * g).epsilon(1e-5));
    e = in_fluid(e, 1.2, 1.8e-3);
    const double slow = of("speed", e, w, {15.0})[0], small_re = 1.2 * slow * 2.0 * radius / 1.8e-3;
    REQUIRE(small_re < 1000.0);
    const double cd = 24.0 / small_re * (1.0 + 0.15 * std::pow(small_re, 0.687));
    REQUIRE(0.5 * 1.2 * cd * factor * pi * radius * radius * slow * slow ==
            Approx(m * g).epsilon(1e-5));
}

// Energy: the image pulls with q^2/(16 pi eps0 (R + h)^2), whose potential is that over (R + h).
TEST_CASE("an image charge brings a charged grain down", "[rigs][forward][drop][exact]") {
    const double q = 3e-9, h = 3e-3;
    const World w =
        with(a_world({"hertz_mindlin"}, {{"restitution", 0.5}}), "electrostatic", {{"charge", q}});
    const auto v = of("impact_speed", glass_experiment("drop", {{"height", "3 mm"}}), w,
                      evenly(0.0, 2.0, 4000));
    const double k = q * q / (16.0 * pi * 8.8541878128e-12);
    const double expected = std::sqrt(2.0 * k / m * (1.0 / radius - 1.0 / (radius + h)));
    const auto first = std::find_if(v.begin(), v.end(), [](double x) { return x > 0.0; });
    REQUIRE(first != v.end());
    REQUIRE(*first == Approx(expected).epsilon(1e-6));  // a step is right to 1e-8
}

// Its work from contact to rupture: F (h - sqrt(h^2 + b) + sqrt b), b = V/(pi R).
TEST_CASE("a liquid bridge takes its work from the rebound and then lets go",
          "[rigs][forward][drop][exact]") {
    const double gamma = 0.07, volume = 2e-11, e = 0.8, v = 0.2;
    const World w = with(a_world({"hertz_mindlin"}, {{"restitution", e}}), "capillary_bridge",
                         {{"surface_tension", gamma}, {"liquid_volume", volume}});
    const double rupture = std::cbrt(volume), b = volume / (pi * radius);
    const double work =
        4.0 * pi * gamma * radius * (rupture - std::sqrt(rupture * rupture + b) + std::sqrt(b));
    const double after = std::sqrt(e * e * v * v - 2.0 * work / m);
    const auto speed =
        of("speed", glass_experiment("drop", {{"height", "5 mm"}, {"speed", "0.2 m/s"}}), w,
           {0.02, 0.2});
    REQUIRE(speed[0] == Approx(v).epsilon(1e-9));  // no bridge before the first contact
    REQUIRE(speed[1] == Approx(after).epsilon(1e-6));
}

// From far off: A R/(6 h0) outside h0 and as much again inside it.
TEST_CASE("van der Waals' tail speeds a small grain up before it touches",
          "[rigs][forward][drop][exact]") {
    cases::Experiment e = glass_experiment("drop", {{"height", "10 um"}, {"speed", "20 mm/s"}});
    e.grain.diameter.value = scaling::in_si<scaling::Length>(2e-6);
    const double a = 1e-19, r = 1e-6, mass = m * std::pow(r / radius, 3), h0 = 0.165e-9;
    const World w = with(a_world({"hertz_mindlin"}, {{"restitution", 1.0}}), "van_der_waals",
                         {{"hamaker_constant", a}});
    const auto v = of("impact_speed", e, w, {6e-4});
    const double gained = a * r / 3.0 / h0 - a * r / 6.0 / 1e-5;
    REQUIRE(v[0] == Approx(std::sqrt(4e-4 + 2.0 * gained / mass)).epsilon(1e-6));
}

// The hysteresis of JKR costs 7.0922 (w^5 R^4/E*^2)^(1/3) (contact/jkr.hpp); with e = 1 nothing else is lost. Five digits.
TEST_CASE("with adhesion a rebound pays for the tear-off, or stays",
          "[rigs][forward][drop][exact]") {
    const double w_adh = 0.5, e_star = 0.5 * 6e10 / (1.0 - 0.22 * 0.22);
    const double work =
        7.0922 * std::cbrt(std::pow(w_adh, 5) * std::pow(radius, 4) / (e_star * e_star));
    const double sticking = std::sqrt(2.0 * work / m);
    const World w = with(a_world({"hertz_mindlin"}, {{"restitution", 1.0}}), "adhesion",
                         {{"work_of_adhesion", w_adh}});
    const auto rebound = [&](double speed) {
        const auto v = of("speed",
                          glass_experiment("drop", {{"height", "1 mm"},
                                                    {"speed", std::to_string(speed) + " m/s"}}),
                          w, {2.5e-3 / speed});
        return v[0];
    };
    const double fast = 3.0 * sticking;
    REQUIRE(rebound(fast) == Approx(std::sqrt(fast * fast - sticking * sticking)).epsilon(2e-4));
    REQUIRE(rebound(0.98 * sticking) == 0.0);
    REQUIRE(rebound(1.02 * sticking) > 0.0);
}

TEST_CASE("restitution falls with speed as its law says", "[rigs][forward][drop][exact]") {
    const auto ratio = [](const World& w) {
        const auto v =
            of("impact_speed", glass_experiment("drop", {{"height", "200 mm"}}), w, {0.25, 0.55});
        return std::pair{v[0], v[1] / v[0]};
    };
    const auto [v, viscous] =
        ratio(with(bouncing(0.9), "viscoelastic_restitution", {{"loss_coefficient", 0.15}}));
    REQUIRE(viscous == Approx(1.0 - 0.15 * std::pow(v, 0.2)).epsilon(1e-12));
    const auto [u, plastic] =
        ratio(with(bouncing(0.9), "plastic_restitution", {{"yield_velocity", 0.5}}));
    REQUIRE(plastic == Approx(0.9 * std::pow(0.5 / u, 0.25)).epsilon(1e-12));
}

// Timed so that the plate passes its mean at its fastest when the grain arrives: v' = e v + (1 + e) A omega.
TEST_CASE("a plate that comes up throws the grain higher", "[rigs][forward][drop][exact]") {
    const double e = 0.7, fall = std::sqrt(2.0 * 0.2 / g), f = 4.0, amplitude = 1e-3;
    const World w =
        with(bouncing(e), "vibration",
             {{"amplitude", amplitude}, {"frequency", f}, {"phase", -2.0 * pi * f * fall}});
    const double up = e * g * fall + (1.0 + e) * amplitude * 2.0 * pi * f, dt = 0.1;
    const auto z = z_of({{"height", "200 mm"}}, w, {fall + dt});
    REQUIRE(z[0] ==
            Approx(up * dt - 0.5 * g * dt * dt).epsilon(1e-3));  // contact lasts 30 us of 0.1 s
}

TEST_CASE("on a tilted plate a grain drifts down the slope", "[rigs][forward][drop][exact]") {
    const double tilt = 0.1, azimuth = 0.6;
    const World w = with(bouncing(0.5), "tilt", {{"tilt_angle", tilt}, {"tilt_azimuth", azimuth}});
    const cases::Experiment e = glass_experiment("drop", {{"height", "300 mm"}});
    REQUIRE(of("x", e, w, {0.2})[0] ==
            Approx(0.5 * g * std::sin(tilt) * std::cos(azimuth) * 0.04).epsilon(1e-12));
    REQUIRE(of("z", e, w, {0.2})[0] ==
            Approx(0.3 - 0.5 * g * std::cos(tilt) * 0.04).epsilon(1e-12));
    // At rest it rolls: 5/7 g sin(tilt).
    const auto v = of("speed", e, w, {5.0, 6.0});
    REQUIRE(v[1] - v[0] ==
            Approx(5.0 / 7.0 * g * std::sin(tilt) * std::cos(azimuth)).epsilon(1e-9));
}

TEST_CASE("a missing force of one size is a smaller gravity", "[rigs][forward][drop][exact]") {
    World w = bouncing(0.7), lighter = bouncing(0.7);
    w.missing = {"z", {0.0, 0.1, 1.0}, {0.3 * m * g, 0.3 * m * g, 0.3 * m * g}};
    lighter.stated["surroundings.gravity"] = 0.7 * g;
    const std::vector<double> t = evenly(0.0, 1.0, 101);
    // At z = 0 it holds the grain up in flight only, so that all but rest is the same.
    REQUIRE(largest_difference(z_of({{"height", "200 mm"}}, w, t),
                               z_of({{"height", "200 mm"}}, lighter, t)) < 1e-8);
}

TEST_CASE("a restitution that is missing a tenth is a smaller one",
          "[rigs][forward][drop][exact]") {
    World w = bouncing(0.7), slower = bouncing(0.63);
    w.missing_restitution = {"impact_speed", {0.1, 1.0}, {-0.1, -0.1}};
    const std::vector<double> t = evenly(0.0, 0.8, 81);
    // A contact's own duration goes with its damping: some 20 us of 0.2 s each.
    REQUIRE(largest_difference(z_of({{"height", "200 mm"}}, w, t),
                               z_of({{"height", "200 mm"}}, slower, t)) < 1e-5);
}

// dem_min at 4000 steps an impact. There friction acts at the sunken contact, nearer to the centre by 0.25 % of R, which
// moves the slip by (5/7) 2 0.25 % at most.
TEST_CASE("an oblique bounce is that of the core", "[rigs][forward][drop][pair]") {
    const double e = 0.8, mu = 0.3, v = 1.0;
    const double along = GENERATE(0.1, 0.4, 0.9, 3.0);
    const bool rigid = GENERATE(false, true);
    const cases::Experiment ex =
        glass_experiment("drop", {{"height", "1 mm"},
                                  {"speed", "1 m/s"},
                                  {"horizontal_speed", std::to_string(along) + " m/s"}});
    World w = a_world({rigid ? "hertz_coulomb" : "hertz_mindlin"},
                      {{"restitution", e}, {"sliding_friction", mu}});
    const auto x = of("x", ex, w, {0.1, 0.2});
    const double after = (x[1] - x[0]) / 0.1;

    rigs::ContactParameters c =
        rigs::elastic_parameters(rigs::grain_material(ex), rigs::plate_material(ex));
    c.restitution = e, c.sliding_friction = mu, c.rigid_tangential = rigid;
    const double impact = 2.87 * std::pow(m * m / (radius * c.e_star * c.e_star * v), 0.2);
    dem_min::Simulation sim;
    sim.settings = {
        .time_step = impact / 4000.0, .skin = radius, .gravity = {}, .lost_below = -radius};
    sim.between_grains = sim.at_walls = rigs::laws(c);
    sim.walls = {dem_min::Plane{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}};
    dem_min::insert(sim, {{0.0, 0.0, radius + 1e-9}, {along, 0.0, -v}, {}, radius, glass_density});
    for (int k = 0; k < 6000; ++k) dem_min::step(sim);
    REQUIRE(sim.grains.vz[0] == Approx(e * v).epsilon(1e-3));
    REQUIRE(after - along == Approx(sim.grains.vx[0] - along).epsilon(5e-3));
}

TEST_CASE("a step that is too long bounces wrongly, and a short one does not",
          "[rigs][forward][drop]") {
    const double v = std::sqrt(2.0 * g * 0.2), e_star = 0.5 * 6e10 / (1.0 - 0.22 * 0.22);
    const double impact = 2.87 * std::pow(m * m / (radius * e_star * e_star * v), 0.2);
    const auto peak = [&](double share, const std::string& integrator) {
        World w = bouncing(0.8);
        w.numerics =
            cases::Numerics{scaling::in_si<scaling::Time>(share * impact), integrator, 1.0};
        const auto z = z_of({{"height", "200 mm"}}, w, evenly(0.25, 0.5, 500));
        return *std::max_element(z.begin(), z.end());
    };
    const double right = 0.64 * 0.2;
    REQUIRE(peak(1.0 / 1000.0, "verlet") == Approx(right).epsilon(5e-3));
    REQUIRE(std::abs(peak(0.4, "verlet") / right - 1.0) > 0.05);
    REQUIRE(peak(1.0 / 20.0, "euler") > 1.05 * right);  // explicit Euler gains energy
}

TEST_CASE("a softened grain stays longer in contact", "[rigs][forward][drop]") {
    World soft = bouncing(0.8);
    soft.numerics = cases::Numerics{std::nullopt, "", 1e-6};
    const double v = std::sqrt(2.0 * g * 0.2), fall = v / g;
    const auto z = z_of({{"height", "200 mm"}}, soft, {fall + 1e-3});
    REQUIRE(z[0] < -1e-4);  // E^(-2/5): 250 times the time of 30 us
}

TEST_CASE("every effect moves the channels of a drop", "[rigs][forward][drop][liveness]") {
    using Parameters = std::map<std::string, double>;
    const auto [effect, parameters] = GENERATE(table<std::string, Parameters>({
        {"air_drag", {}},
        {"buoyancy", {}},
        {"adhesion", {{"work_of_adhesion", 1.0}}},
        {"van_der_waals", {{"hamaker_constant", 1e-15}}},
        {"capillary_bridge", {{"surface_tension", 0.07}, {"liquid_volume", 1e-11}}},
        {"electrostatic", {{"charge", 1e-9}}},
        {"rolling_resistance", {{"rolling_friction", 0.05}}},
        {"viscoelastic_restitution", {{"loss_coefficient", 0.1}}},
        {"plastic_restitution", {{"yield_velocity", 0.5}}},
        {"velocity_dependent_friction", {{"friction_velocity", 0.5}, {"dynamic_friction", 0.05}}},
        {"tangential_compliance", {{"stiffness_ratio", 0.6}}},
        {"tilt", {{"tilt_angle", 0.01}}},
        {"vibration", {{"amplitude", 1e-4}, {"frequency", 30.0}}},
    }));
    const cases::Experiment e =
        glass_experiment("drop", {{"height", "20 mm"}, {"horizontal_speed", "0.3 m/s"}});
    REQUIRE(forward_model(e)->effects().count(effect) == 1);
    const std::vector<double> t = evenly(0.0, 1.0, 101);
    const World base = bouncing(0.8), more = with(base, effect, parameters);
    const Curves a = forward_model(e)->predict(base, {t, {}}),
                 b = forward_model(e)->predict(more, {t, {}});
    const double moved = std::max(largest_difference(a.at("z"), b.at("z")),
                                  largest_difference(a.at("x"), b.at("x")));
    REQUIRE(moved > 1e-6);
    for (const auto& [name, value] : parameters) {
        World other = more;
        other.parameters[name] = 1.3 * value;
        const Curves c = forward_model(e)->predict(other, {t, {}});
        INFO(name);
        REQUIRE(std::max(largest_difference(c.at("z"), b.at("z")),
                         largest_difference(c.at("x"), b.at("x"))) > 1e-9);
    }
}

// Fourth differences of a smooth function at steps of 1e-4 are far below what is allowed; jitter would stay. Rows next to a
// touch have a real kink and are left out: at most one in twenty.
TEST_CASE("a drop is smooth in its parameters", "[rigs][forward][drop]") {
    using Parameters = std::map<std::string, double>;
    const auto [effect, name, parameters] = GENERATE(table<std::string, std::string, Parameters>({
        {"tangential_compliance", "restitution", {{"stiffness_ratio", 1.0}}},
        {"tangential_compliance", "sliding_friction", {{"stiffness_ratio", 1.0}}},
        {"air_drag", "drag_factor", {{"drag_factor", 1.0}}},
        {"adhesion", "work_of_adhesion", {{"work_of_adhesion", 0.1}}},
        {"capillary_bridge",
         "liquid_volume",
         {{"surface_tension", 0.07}, {"liquid_volume", 1e-12}}},
        {"electrostatic", "charge", {{"charge", 1e-9}}},
        {"vibration", "amplitude", {{"amplitude", 1e-4}, {"frequency", 30.0}}},
    }));
    const cases::Experiment e =
        glass_experiment("drop", {{"height", "200 mm"}, {"horizontal_speed", "1 m/s"}});
    const auto model = forward_model(e);
    const std::vector<double> t = evenly(0.0, 1.2, 200);
    World w = with(bouncing(0.8), effect, parameters);
    const double centre = w.parameters.at(name);
    const char* channel = GENERATE("z", "x");
    std::vector<double> sum(t.size(), 0.0);
    const double weight[] = {1.0, -4.0, 6.0, -4.0, 1.0};
    for (int k = 0; k < 5; ++k) {
        w.parameters[name] = centre * (1.0 + 1e-4 * (k - 2));
        const Curves c = model->predict(w, {t, {}});
        for (std::size_t i = 0; i < t.size(); ++i) sum[i] += weight[k] * c.at(channel)[i] / 16.0;
    }
    for (double& v : sum) v = std::abs(v);
    std::sort(sum.begin(), sum.end());
    INFO(effect << " " << name << " " << channel);
    REQUIRE(sum[sum.size() * 19 / 20] < (channel[0] == 'z' ? 0.2 : 1.0) * 1e-6);
}

TEST_CASE("several threads get the same drop", "[rigs][forward][drop]") {
    const auto model = forward_model(
        glass_experiment("drop", {{"height", "200 mm"}, {"horizontal_speed", "1 m/s"}}));
    const World w = with(bouncing(0.8), "air_drag", {});
    const rigs::Ordinates o{evenly(0.0, 1.0, 100), {}};
    const auto alone = model->predict(w, o).at("x");
    std::vector<std::vector<double>> found(4);
    std::vector<std::thread> team;
    for (auto& f : found) team.emplace_back([&] { f = model->predict(w, o).at("x"); });
    for (auto& t : team) t.join();
    for (const auto& f : found) REQUIRE(f == alone);
}

TEST_CASE("ordinates may come in any order, and a hole stays a hole", "[rigs][forward][drop]") {
    const auto z = z_of({{"height", "200 mm"}}, bouncing(0.8), {0.5, std::nan(""), 0.1});
    const auto sorted = z_of({{"height", "200 mm"}}, bouncing(0.8), {0.1, 0.5});
    REQUIRE(z[0] == sorted[1]);
    REQUIRE(std::isnan(z[1]));
    REQUIRE(z[2] == sorted[0]);
}

TEST_CASE("a world without a parameter that it needs is refused by name",
          "[rigs][forward][drop][domain]") {
    REQUIRE_THROWS_WITH(z_of({{"height", "1 m"}}, a_world({"hertz_mindlin", "adhesion"}), {0.0}),
                        Catch::Contains("work_of_adhesion"));
    REQUIRE_THROWS_AS(forward_model(glass_experiment("drum", {})), scaling::InvalidInput);
    World w = bouncing(0.5);
    w.missing = {"slip", {0.0}, {0.0}};
    REQUIRE_THROWS_AS(z_of({{"height", "1 m"}}, w, {0.0}), scaling::InvalidInput);
}

TEST_CASE("the drag coefficient of a case holds at the fastest speed",
          "[rigs][forward][drop][exact]") {
    cases::Case c;
    c.path = "case.json";
    c.model.physics = {"gravity", "hertz_mindlin", "air_drag"};
    c.model.parameters["drag_coefficient"] = {0.8, "1", {}};
    cases::Experiment e = glass_experiment("drop", {{"height", "2 m"}});
    e.recording =
        cases::Recording{{{"t", "s", evenly(0.0, 0.6, 50)}, {"z", "m", evenly(0.0, 0.6, 50)}}};
    c.experiments = {e};
    const World w = rigs::world_of(c, e);
    const auto v = of("speed", e, w, e.recording->values("t"));
    const double most = *std::max_element(v.begin(), v.end());
    REQUIRE(w.parameters.at("drag_factor") * rigs::drag_curve(e, most) ==
            Approx(0.8).epsilon(1e-9));
}
