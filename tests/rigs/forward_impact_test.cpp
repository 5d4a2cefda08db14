// SPDX-License-Identifier: MIT
#include "rigs/forward.hpp"
#include "scaling/errors.hpp"
#include "tests/rigs/world_of_glass.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using rigs::Curves;
using rigs::forward_model;
using rigs::World;

namespace {

constexpr double radius = glass_radius;

Curves thrown(const World& w, const std::vector<double>& angles, const Written& more = {}) {
    Written conditions{{"speed", "2 m/s"}};
    conditions.insert(conditions.end(), more.begin(), more.end());
    return forward_model(glass_experiment("impact", conditions))->predict(w, {angles, {}});
}

World glass(const std::string& law, double e, double mu) {
    return a_world({law}, {{"restitution", e}, {"sliding_friction", mu}});
}

}  // namespace

// Walton (1993): it slides throughout where (7/2) mu (1 + e) < tan(angle), else it leaves rolling with 5/7.
TEST_CASE("rigid friction slides throughout or leaves rolling", "[rigs][forward][impact][exact]") {
    const double e = 0.8, mu = 0.15;
    const std::vector<double> angles = evenly(0.05, 1.5, 30);
    const Curves c = thrown(glass("hertz_coulomb", e, mu), angles);
    for (std::size_t k = 0; k < angles.size(); ++k) {
        const double t = std::tan(angles[k]), cap = mu * (1.0 + e) / t;
        const double kept = std::max(5.0 / 7.0, 1.0 - cap), vn = 2.0 * std::cos(angles[k]);
        REQUIRE(c.at("normal_restitution")[k] == Approx(e).epsilon(1e-12));
        REQUIRE(c.at("tangential_restitution")[k] == Approx(kept).epsilon(1e-12));
        REQUIRE(c.at("rebound_angle")[k] == Approx(std::atan(kept * t / e)).epsilon(1e-12));
        REQUIRE(c.at("rebound_spin")[k] ==
                Approx(2.5 * (1.0 - kept) * t * vn / radius).epsilon(1e-12));
    }
}

// Sliding throughout; friction is cut at each node, second order in 256: 1e-4.
TEST_CASE("with micro-slip a grazing impact slides all the same",
          "[rigs][forward][impact][exact]") {
    const double e = 0.9, mu = 0.2;
    const Curves c = thrown(glass("hertz_mindlin", e, mu), {1.4});
    REQUIRE(c.at("tangential_restitution")[0] ==
            Approx(1.0 - mu * (1.0 + e) / std::tan(1.4)).epsilon(1e-4));
}

TEST_CASE("without stiffness a contact holds nothing along the plate",
          "[rigs][forward][impact][limit]") {
    World w = glass("hertz_coulomb", 0.9, 0.2);
    w.physics.insert("tangential_compliance"), w.parameters["stiffness_ratio"] = 1e-12;
    REQUIRE(thrown(w, {0.3}).at("tangential_restitution")[0] == Approx(1.0).epsilon(1e-5));
}

TEST_CASE("rolling resistance acts on the spin with mu_r times the normal impulse",
          "[rigs][forward][impact][exact]") {
    const double e = 0.8, mu = 0.1, mu_r = 0.02, angle = 1.3, vn = 2.0 * std::cos(angle);
    World w = glass("hertz_coulomb", e, mu);
    w.physics.insert("rolling_resistance"), w.parameters["rolling_friction"] = mu_r;
    const Curves c = thrown(w, {angle});
    REQUIRE(c.at("rebound_spin")[0] ==
            Approx(2.5 * (mu - mu_r) * (1.0 + e) * vn / radius).epsilon(1e-12));
    w.parameters["sliding_friction"] = 0.0;
    REQUIRE(thrown(w, {angle}, {{"spin", "500 rad/s"}}).at("rebound_spin")[0] ==
            Approx(500.0 - 2.5 * mu_r * (1.0 + e) * vn / radius).epsilon(1e-12));
}

TEST_CASE("restitution follows the normal speed of each angle", "[rigs][forward][impact][exact]") {
    const std::vector<double> angles{0.0, 0.7, 1.4};
    World w = glass("hertz_mindlin", 0.9, 0.2);
    w.physics.insert("viscoelastic_restitution"), w.parameters["loss_coefficient"] = 0.1;
    const Curves viscous = thrown(w, angles);
    World yields = glass("hertz_mindlin", 0.9, 0.2);
    yields.physics.insert("plastic_restitution"), yields.parameters["yield_velocity"] = 0.5;
    const Curves plastic = thrown(yields, angles);
    for (std::size_t k = 0; k < 3; ++k) {
        const double v = 2.0 * std::cos(angles[k]);
        REQUIRE(viscous.at("normal_restitution")[k] ==
                Approx(1.0 - 0.1 * std::pow(v, 0.2)).epsilon(1e-12));
        REQUIRE(plastic.at("normal_restitution")[k] ==
                Approx(v > 0.5 ? 0.9 * std::pow(0.5 / v, 0.25) : 0.9).epsilon(1e-12));
    }
    REQUIRE(std::isnan(viscous.at("tangential_restitution")[0]));
}

TEST_CASE("every effect moves an impact", "[rigs][forward][impact][liveness]") {
    using Parameters = std::map<std::string, double>;
    const auto [effect, parameters] = GENERATE(table<std::string, Parameters>({
        {"rolling_resistance", {{"rolling_friction", 0.02}}},
        {"viscoelastic_restitution", {{"loss_coefficient", 0.1}}},
        {"plastic_restitution", {{"yield_velocity", 0.5}}},
        {"velocity_dependent_friction", {{"friction_velocity", 0.5}, {"dynamic_friction", 0.05}}},
        {"tangential_compliance", {{"stiffness_ratio", 0.7}}},
    }));
    const std::string law = GENERATE("hertz_coulomb", "hertz_mindlin");
    const World base = glass(law, 0.8, 0.2);
    World more = base;
    more.physics.insert(effect), more.parameters.insert(parameters.begin(), parameters.end());
    REQUIRE(
        forward_model(glass_experiment("impact", {{"speed", "1 m/s"}}))->effects().count(effect) ==
        1);
    const std::vector<double> angles = evenly(0.05, 1.5, 30);
    const Curves a = thrown(base, angles), b = thrown(more, angles);
    REQUIRE(largest_difference(a.at("rebound_spin"), b.at("rebound_spin")) > 1e-3);
    for (const auto& [name, value] : parameters) {
        World other = more;
        other.parameters[name] = 1.2 * value;
        REQUIRE(largest_difference(thrown(other, angles).at("rebound_spin"), b.at("rebound_spin")) >
                1e-5);
    }
}

// One radian of range; nodes where friction yields move with the parameter, which leaves 1/(8 256^2) of a force step.
TEST_CASE("an impact is smooth in its parameters", "[rigs][forward][impact]") {
    const auto name =
        GENERATE(as<std::string>(), "restitution", "sliding_friction", "stiffness_ratio");
    World w = glass("hertz_coulomb", 0.8, 0.2);
    w.physics.insert("tangential_compliance"), w.parameters["stiffness_ratio"] = 1.0;
    const double centre = w.parameters.at(name), weight[] = {1.0, -4.0, 6.0, -4.0, 1.0};
    std::vector<double> sum(30, 0.0);
    for (int k = 0; k < 5; ++k) {
        w.parameters[name] = centre * (1.0 + 1e-4 * (k - 2));
        const auto angle = thrown(w, evenly(0.05, 1.5, 30)).at("rebound_angle");
        for (std::size_t i = 0; i < angle.size(); ++i) sum[i] += weight[k] * angle[i] / 16.0;
    }
    for (const double v : sum) REQUIRE(std::abs(v) < 1e-6);
}

TEST_CASE("a step that is too long throws a grain back wrongly", "[rigs][forward][impact]") {
    World w = glass("hertz_mindlin", 0.8, 0.2);
    const std::vector<double> angles{0.3, 0.9};
    const Curves exact = thrown(w, angles);
    const auto at = [&](double step) {
        w.numerics = cases::Numerics{scaling::in_si<scaling::Time>(step), "verlet", 1.0};
        return thrown(w, angles);
    };
    const Curves fine = at(1e-8), coarse = at(1e-5);  // the contact lasts some 17 us
    for (std::size_t k = 0; k < 2; ++k) {
        REQUIRE(fine.at("normal_restitution")[k] == Approx(0.8).epsilon(2e-3));
        REQUIRE(fine.at("rebound_angle")[k] == Approx(exact.at("rebound_angle")[k]).epsilon(1e-2));
        REQUIRE(std::abs(coarse.at("normal_restitution")[k] - 0.8) > 0.05);
    }
}

TEST_CASE("a missing restitution takes its share of the rebound and no more",
          "[rigs][forward][impact][exact]") {
    World w = glass("hertz_coulomb", 0.8, 0.15);
    const std::vector<double> angles{0.1, 0.3, 0.7, 1.2};
    const Curves plain = thrown(w, angles);
    w.missing_restitution = {"impact_angle", {0.2, 0.4, 1.0}, {0.0, -0.1, -0.4}};
    const Curves angled = thrown(w, angles);
    const double kept[] = {1.0, 0.95, 0.75, 0.6};  // straight between, constant beyond
    for (std::size_t k = 0; k < angles.size(); ++k) {
        REQUIRE(angled.at("normal_restitution")[k] == Approx(0.8 * kept[k]).epsilon(1e-12));
        REQUIRE(angled.at("rebound_spin")[k] == plain.at("rebound_spin")[k]);
    }
    // 2 m/s times cos(angle): 1.99, 1.91, 1.53, 0.72 m/s.
    w.missing_restitution = {"impact_speed", {1.0, 1.8}, {-0.2, 0.0}};
    const Curves fast = thrown(w, angles);
    REQUIRE(fast.at("normal_restitution")[0] == Approx(0.8).epsilon(1e-12));
    REQUIRE(fast.at("normal_restitution")[3] == Approx(0.64).epsilon(1e-12));
    w.missing_restitution = {"angle", {0.2}, {0.0}};
    REQUIRE_THROWS_AS(thrown(w, {0.3}), scaling::InvalidInput);
    w.missing_restitution = {"impact_angle", {0.2, 0.4}, {0.0}};
    REQUIRE_THROWS_AS(thrown(w, {0.3}), scaling::InvalidInput);
    // Less than nothing is nothing.
    w.missing_restitution = {"impact_angle", {0.0}, {-3.0}};
    REQUIRE(thrown(w, {0.3}).at("normal_restitution")[0] == 0.0);
}

TEST_CASE("an impact has no room for a missing force", "[rigs][forward][impact][domain]") {
    World w = glass("hertz_mindlin", 0.8, 0.2);
    w.missing = {"angle", {0.0}, {0.0}};
    REQUIRE_THROWS_AS(thrown(w, {0.3}), scaling::InvalidInput);
}
