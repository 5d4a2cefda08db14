// SPDX-License-Identifier: MIT
#include "rigs/forward.hpp"
#include "tests/rigs/world_of_glass.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using rigs::forward_model;
using rigs::World;

namespace {

constexpr double pi = std::numbers::pi, radius = glass_radius;
constexpr double e_star = 0.5 * 6e10 / (1.0 - 0.22 * 0.22);

cases::Experiment force_curve(const std::string& counterpart, const Written& more = {}) {
    Written conditions{{"preload", "1 mN"}};
    conditions.insert(conditions.end(), more.begin(), more.end());
    cases::Experiment e = glass_experiment("pull_off", conditions);
    cases::Value word{
        .where = "test.counterpart", .kind = cases::Value::Kind::text, .written_text = counterpart};
    e.conditions.members.emplace_back("counterpart", word);
    return e;
}

cases::Experiment driven(cases::Experiment e) {
    e.recording = cases::Recording{{{"displacement", "m", {0.0}}, {"force", "N", {0.0}}}};
    return e;
}

std::vector<double> force(const cases::Experiment& e, const World& w, const std::vector<double>& at,
                          bool retract) {
    return forward_model(e)->predict(w, {at, std::vector<bool>(at.size(), retract)}).at("force");
}

double force(const cases::Experiment& e, const World& w, double at, bool retract) {
    return force(e, w, std::vector<double>{at}, retract)[0];
}

World sticky(double w) { return a_world({"hertz_mindlin", "adhesion"}, {{"work_of_adhesion", w}}); }

}  // namespace

// 3/2 pi w R, and 5/9 of it at the fold, 8/9 at overlap 0: Johnson, Kendall & Roberts (1971); contact/jkr.hpp.
TEST_CASE("the deepest tension on the way back is the pull-off force",
          "[rigs][forward][pull_off][exact]") {
    const double w = 0.1, pull_off = 1.5 * pi * w * radius;
    const double unit = std::cbrt(std::pow(pi * w / (2.0 * e_star), 2) * radius);  // L^2/R
    const cases::Experiment e = force_curve("plate");
    const auto back = force(e, sticky(w), evenly(-unit, 1.2 * unit, 20001), true);
    REQUIRE(*std::min_element(back.begin(), back.end()) == Approx(-pull_off).epsilon(1e-6));
    REQUIRE(force(e, sticky(w), 0.0, true) == Approx(-8.0 / 9.0 * pull_off).epsilon(1e-12));
    REQUIRE(force(e, sticky(w), 1.19055 * unit, true) ==
            Approx(-5.0 / 9.0 * pull_off).epsilon(5e-3));
    REQUIRE(force(e, sticky(w), 1.1906 * unit, true) == 0.0);
    REQUIRE(force(e, sticky(w), 0.1 * unit, false) == 0.0);  // no contact before the touch
}

TEST_CASE("without adhesion a pressed contact is Hertz', between grains with half the radius",
          "[rigs][forward][pull_off][exact]") {
    const double d = 1e-7;
    const World w = a_world({"hertz_mindlin"});
    const double plate = 4.0 / 3.0 * e_star * std::sqrt(radius) * std::pow(d, 1.5);
    REQUIRE(force(force_curve("plate"), w, -d, false) == Approx(plate).epsilon(1e-12));
    REQUIRE(force(force_curve("grain"), w, -d, true) ==
            Approx(plate / std::sqrt(2.0)).epsilon(1e-12));
}

TEST_CASE("a liquid bridge pulls on the way back only, until it ruptures",
          "[rigs][forward][pull_off][exact]") {
    const double gamma = 0.07, volume = 1e-12, theta = 0.5, b = volume / (pi * radius), h = 2e-5;
    const World w =
        a_world({"hertz_mindlin", "capillary_bridge"},
                {{"surface_tension", gamma}, {"liquid_volume", volume}, {"contact_angle", theta}});
    const cases::Experiment e = force_curve("plate");
    const double closed = 4.0 * pi * gamma * radius * std::cos(theta);
    REQUIRE(force(e, w, h, false) == 0.0);
    REQUIRE(force(e, w, 0.0, true) == Approx(-closed).epsilon(1e-12));
    REQUIRE(force(e, w, h, true) ==
            Approx(-closed * (1.0 - h / std::sqrt(h * h + b))).epsilon(1e-12));
    const double rupture = (1.0 + 0.5 * theta) * std::cbrt(volume);
    REQUIRE(force(e, w, 0.999 * rupture, true) < 0.0);
    REQUIRE(force(e, w, 1.001 * rupture, true) == 0.0);
}

TEST_CASE("charges attract a plate by their image and repel each other",
          "[rigs][forward][pull_off][exact]") {
    const double q = 1e-10, h = 1e-4, unit = q * q / (pi * 8.8541878128e-12);
    const World w = a_world({"hertz_mindlin", "electrostatic"}, {{"charge", q}});
    REQUIRE(force(force_curve("plate"), w, h, false) ==
            Approx(-unit / 16.0 / std::pow(radius + h, 2)).epsilon(1e-12));
    REQUIRE(force(force_curve("grain"), w, h, false) ==
            Approx(unit / 4.0 / std::pow(2.0 * radius + h, 2)).epsilon(1e-12));
}

TEST_CASE("van der Waals' tail falls with the square of the gap",
          "[rigs][forward][pull_off][exact]") {
    const double a = 6.5e-20;
    const World w = a_world({"hertz_mindlin", "van_der_waals"}, {{"hamaker_constant", a}});
    REQUIRE(force(force_curve("plate"), w, 5e-9, false) ==
            Approx(-a * radius / (6.0 * 25e-18)).epsilon(1e-12));
    REQUIRE(force(force_curve("grain"), w, 5e-9, true) ==
            Approx(-a * radius / (12.0 * 25e-18)).epsilon(1e-12));
    REQUIRE(force(force_curve("plate"), w, 1e-11, false) ==
            Approx(-a * radius / (6.0 * 0.165e-9 * 0.165e-9)).epsilon(1e-12));
}

// In with the gradient A R/(3 h^3) = k; then separation = x + F/k (the spring carries the force).
TEST_CASE("a soft cantilever jumps in where the tail outgrows it",
          "[rigs][forward][pull_off][exact]") {
    const double a = 6.5e-20, k = 0.5;
    const World w = a_world({"hertz_mindlin", "van_der_waals"}, {{"hamaker_constant", a}});
    const cases::Experiment e = driven(force_curve(
        "plate", {{"cantilever_stiffness", "0.5 N/m"}, {"contact_displacement", "10 nm"}}));
    const double h = std::cbrt(a * radius / (3.0 * k)), f = a * radius / (6.0 * h * h),
                 x = h + f / k + 1e-8;
    const double before = force(e, w, x * 1.0001, false), after = force(e, w, x * 0.9999, false);
    REQUIRE(before ==
            Approx(-f).epsilon(0.05));  // the edge is a square root: 1e-2 in h for 1e-4 in x
    REQUIRE(std::abs(after - before) > 0.2 * f);
}

TEST_CASE("a soft cantilever stays on until the pull-off force, and then jumps off",
          "[rigs][forward][pull_off][exact]") {
    const double w = 0.1, k = 20.0, pull_off = 1.5 * pi * w * radius;
    const cases::Experiment e = driven(force_curve("plate", {{"cantilever_stiffness", "20 N/m"}}));
    const auto at = evenly(-1e-4, 2e-4, 60001);
    const auto f = force(e, sticky(w), at, true);
    const auto deepest = std::min_element(f.begin(), f.end());
    REQUIRE(*deepest == Approx(-pull_off).epsilon(1e-3));
    // The spring is stretched by F_po/k there, far beyond the contact's own way of some tenths of a micrometre.
    REQUIRE(at[static_cast<std::size_t>(deepest - f.begin())] ==
            Approx(pull_off / k).epsilon(0.02));
    REQUIRE(*(deepest + 1) == 0.0);
    // Pressed, the spring is by far the softer: F = -k x.
    REQUIRE(force(e, sticky(w), -1e-4, true) == Approx(k * 1e-4).epsilon(0.01));
}

// The drive's reading is written down for a contact that is known: x = -overlap - F/k, from Hertz' law and from JKR's two equations
// (Johnson, Kendall & Roberts 1971), stiff and soft against the contact.
TEST_CASE("behind a cantilever spring and contact carry the same force",
          "[rigs][forward][pull_off][exact]") {
    const World bare = a_world({"hertz_mindlin"}, {});
    const double w = 0.1;
    for (const char* stiffness : {"20 N/m", "1000000 N/m"}) {
        const double k = std::stod(stiffness);
        const cases::Experiment e =
            driven(force_curve("plate", {{"cantilever_stiffness", stiffness}}));
        for (const double a : {4e-6, 2e-5}) {  // contact radius; the deepest tension has 3.5e-6
            const double hertz = 4.0 / 3.0 * e_star * a * a * a / radius, deep = a * a / radius;
            REQUIRE(force(e, bare, -deep - hertz / k, true) == Approx(hertz).epsilon(1e-11));
            const double jkr = hertz - std::sqrt(8.0 * pi * w * e_star * a * a * a),
                         overlap = deep - std::sqrt(2.0 * pi * w * a / e_star);
            REQUIRE(force(e, sticky(w), -overlap - jkr / k, true) == Approx(jkr).epsilon(1e-9));
        }
    }
}

TEST_CASE("every effect moves a force curve", "[rigs][forward][pull_off][liveness]") {
    using Parameters = std::map<std::string, double>;
    const auto [effect, parameters] = GENERATE(table<std::string, Parameters>({
        {"adhesion", {{"work_of_adhesion", 0.1}}},
        {"van_der_waals", {{"hamaker_constant", 1e-19}}},
        {"capillary_bridge",
         {{"surface_tension", 0.07}, {"liquid_volume", 1e-15}, {"contact_angle", 0.3}}},
        {"electrostatic", {{"charge", 1e-10}}},
    }));
    const bool spring = GENERATE(false, true);
    const cases::Experiment e =
        spring ? driven(force_curve("plate", {{"cantilever_stiffness", "100 kN/m"}}))
               : force_curve("plate");
    REQUIRE(forward_model(e)->effects().count(effect) == 1);
    const World base = a_world({"hertz_mindlin"}),
                more = a_world({"hertz_mindlin", effect}, parameters);
    const auto at = evenly(-1e-7, 1e-6, 400);
    const auto f = force(e, more, at, true);
    REQUIRE(largest_difference(force(e, base, at, true), f) > 1e-9);
    for (const auto& [name, value] : parameters) {
        World other = more;
        other.parameters[name] = 1.2 * value;
        INFO(name);
        REQUIRE(largest_difference(force(e, other, at, true), f) > 1e-10);
    }
}

TEST_CASE("a missing force is added to the contact's", "[rigs][forward][pull_off]") {
    World w = sticky(0.05);
    const auto at = evenly(-1e-7, 3e-7, 50);
    const auto without = force(force_curve("plate"), w, at, true);
    w.missing = {"separation", {-1e-6, 1e-6}, {2e-4, 2e-4}};
    const auto with = force(force_curve("plate"), w, at, true);
    for (std::size_t k = 0; k < at.size(); ++k)
        REQUIRE(with[k] == Approx(without[k] + 2e-4).margin(1e-15));
}
