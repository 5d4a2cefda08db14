// SPDX-License-Identifier: MIT
#include "scaling/pi_groups.hpp"

#include "scaling/errors.hpp"
#include "scaling/jkr_estimates.hpp"
#include "scaling/numbers.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace scaling;

namespace {

// Round values, so that no two groups agree by chance.
const std::vector<Variable> powder = {{"density", "density", 5600.0},
                                      {"gravity", "gravity", 9.81},
                                      {"grain_diameter", "length", 1.2e-6},
                                      {"apparatus_length", "apparatus_length", 6e-3},
                                      {"youngs_modulus", "youngs_modulus", 1.56e8},
                                      {"work_of_adhesion", "work_of_adhesion", 0.06},
                                      {"velocity", "velocity", 1.1},
                                      {"equilibrium_separation", "length", 0.165e-9},
                                      {"fluid_density", "density", 1.2},
                                      {"fluid_viscosity", "viscosity", 1.8e-5},
                                      {"surface_tension", "surface_tension", 0.072},
                                      {"liquid_volume", "liquid_volume", 1e-21}};

const PiGroup& named(const std::vector<PiGroup>& groups, const std::string& name) {
    const auto found = std::find_if(groups.begin(), groups.end(),
                                    [&](const PiGroup& g) { return g.name == name; });
    INFO(name);
    REQUIRE(found != groups.end());
    return *found;
}

std::vector<std::string> names_of(const std::vector<PiGroup>& groups) {
    std::vector<std::string> names;
    for (const PiGroup& g : groups) names.push_back(g.name);
    return names;
}

std::vector<Variable> first(std::size_t count) {
    return {powder.begin(), powder.begin() + static_cast<std::ptrdiff_t>(count)};
}

}  // namespace

TEST_CASE("pi: in every group the dimensions cancel", "[pi]") {
    for (const PiGroup& g : groups_of(powder, named_groups(0.3))) {
        INFO(g.name << ": " << dimension_proof(g, powder));
        CHECK(dimension_of(g, powder).dimensionless());
    }
}

TEST_CASE("pi: the proof is the product written out", "[pi]") {
    REQUIRE(dimension_proof(named(named_groups(0.3), "weight_bond"), powder) ==
            "[M T^-2] [M L^-3]^-1 [L T^-2]^-1 [L]^-2 = 1");
}

TEST_CASE("pi: six variables in three dimensions have three groups, named as the field names them",
          "[pi]") {
    // density, gravity, d, D, E, w: E/(rho g d), D/d and w/(rho g d^2), the weight Bond number but
    // for 9/4.
    REQUIRE(names_of(pi_basis(first(6), named_groups(0.3))) ==
            std::vector<std::string>{"size_ratio", "grain_stiffness", "weight_bond"});
}

TEST_CASE("pi: the pendulum has t^2 g / L", "[pi]") {
    const std::vector<Variable> pendulum = {{"length", "length", 1.0},
                                            {"gravity", "gravity", 9.81},
                                            {"mass", "mass", 1.0},
                                            {"period", "time", 2.0}};
    const std::vector<PiGroup> basis = pi_basis(pendulum, {});
    REQUIRE(names_of(basis) == std::vector<std::string>{"gravity period^2 / length"});
    REQUIRE(value_of(basis[0], pendulum) == Approx(39.24).epsilon(1e-12));
}

TEST_CASE("pi: which variables repeat is the caller's order, and the basis is the same each time",
          "[pi]") {
    const std::vector<Variable> elastic = {powder[4], powder[0], powder[2], powder[5],
                                           powder[1]};  // E, rho, d, w, g
    REQUIRE(names_of(pi_basis(elastic, named_groups(0.3))) ==
            std::vector<std::string>{"elastic_adhesion", "grain_stiffness"});
    REQUIRE(names_of(pi_basis(elastic, {})) ==
            std::vector<std::string>{"work_of_adhesion / (youngs_modulus grain_diameter)",
                                     "density grain_diameter gravity / youngs_modulus"});
}

TEST_CASE("pi: a case's groups hold a whole basis", "[pi]") {
    // n - 3 independent groups: no group of the basis may be independent of those given.
    const std::vector<PiGroup> all = named_groups(0.3), groups = groups_of(powder, all);
    RationalSystem span;
    const auto row = [&](const PiGroup& g) {
        Row r(powder.size(), Rational(0));
        for (const Power& p : g.powers) {
            for (std::size_t k = 0; k < powder.size(); ++k) {
                if (powder[k].name == p.name) r[k] += p.exponent;
            }
        }
        return r;
    };
    for (const PiGroup& g : groups) span.add(row(g), {});
    REQUIRE(span.rank() == powder.size() - 3);
    REQUIRE(pi_basis(powder, all).size() == powder.size() - 3);
}

TEST_CASE("pi: each named group has the value of its plain function", "[pi][numbers]") {
    const double nu = 0.3;
    const Density rho = 5600.0 * si::kilogrammes_per_cubic_metre,
                  air = 1.2 * si::kilogrammes_per_cubic_metre;
    const Acceleration g = 9.81 * si::meters_per_second_squared;
    const Length d = 1.2e-6 * si::meters, radius = 0.5 * d, r_star = 0.25 * d,
                 outlet = 6e-3 * si::meters;
    const Pressure e = 1.56e8 * si::pascals, e_star = effective_modulus(e, nu),
                   stress = rho * g * outlet;
    const EnergyPerArea w = 0.06 * si::newtons_per_meter, sigma = 0.072 * si::newtons_per_meter;
    const Velocity v = 1.1 * si::meters_per_second;
    const Viscosity eta = 1.8e-5 * si::pascals * si::seconds;
    const Mass m = grain_mass(d, rho);
    const JkrPair pair{w, e_star, r_star};
    const Force bridge = 2.0 * 3.14159265358979323846 * sigma * radius;
    const std::vector<std::pair<std::string, double>> expected = {
        {"weight_bond", weight_bond_number(pair.pull_off_force(), m, g)},
        {"stress_bond", stress_bond_number(pair.pull_off_force(), stress, radius)},
        {"cohesion_number", cohesion_number(w, e_star, radius, rho, g)},
        {"sticking_velocity", Dimensionless(pair.sticking_speed(0.5 * m) / v).value()},
        {"elastic_adhesion", elastic_adhesion_number(w, e, radius)},
        {"tabor", tabor_number(w, e_star, r_star, equilibrium_separation)},
        {"size_ratio", 5000.0},
        {"stiffness", stiffness_number(e, rho, g, outlet)},
        {"grain_stiffness", stiffness_number(e, rho, g, d)},
        {"froude", froude_number(v, g, outlet)},
        {"inertial_number", inertial_number(Frequency(v / outlet), d, rho, stress)},
        {"cauchy", cauchy_number(rho, v, e)},
        {"density_ratio", 1.2 / 5600.0},
        {"reynolds", reynolds_number(air, v, d, eta)},
        {"stokes", stokes_number(rho, v, d, eta)},
        {"galilei", galilei_number(rho, air, g, d, eta)},
        {"capillary", capillary_number(eta, v, sigma)},
        {"capillary_bond", weight_bond_number(bridge, m, g)},
        {"liquid_content", 1e-21 / 0.216e-18},
    };
    const std::vector<PiGroup> groups = named_groups(nu);
    REQUIRE(groups.size() == expected.size());
    for (const auto& [name, value] : expected) {
        INFO(name);
        CHECK(value_of(named(groups, name), powder) == Approx(value).epsilon(1e-12));  // algebra
    }
}

TEST_CASE(
    "pi: coarse graining at fixed w breaks the weight Bond number by h^-2 and the inertial number "
    "by h",
    "[pi]") {
    const Scheme scheme = own_scheme(
        {"density", "gravity", "youngs_modulus", "apparatus_length", "surface_energy"}, true);
    const ScaleMap map = ScaleMap::solve(scheme, 200.0);
    const auto exponent = [&](const char* name) {
        return change_of(named(named_groups(0.3), name), powder, map).h;
    };
    REQUIRE(exponent("weight_bond") == Rational(-2));
    REQUIRE(exponent("stress_bond") == Rational(-1));
    REQUIRE(exponent("inertial_number") == Rational(1));
    REQUIRE(exponent("size_ratio") == Rational(-1));
    REQUIRE(exponent("stiffness") == Rational(0));
    REQUIRE(exponent("grain_stiffness") == Rational(-1));
    REQUIRE(exponent("froude") == Rational(0));
}

TEST_CASE("pi: original, scaled and ratio of a broken and of a kept group", "[pi]") {
    const ScaleMap map = ScaleMap::solve(named_scheme("coarse_grain"), 200.0);
    const std::vector<GroupChange> changes = compare_groups(
        {named(named_groups(0.3), "size_ratio"), named(named_groups(0.3), "stiffness")}, powder,
        map);
    REQUIRE(changes[0].original == Approx(5000.0).epsilon(1e-12));
    REQUIRE(changes[0].scaled == Approx(25.0).epsilon(1e-12));
    REQUIRE(changes[0].ratio == Approx(0.005).epsilon(1e-12));
    REQUIRE_FALSE(changes[0].kept);
    REQUIRE(changes[1].kept);
    REQUIRE(changes[1].ratio == 1.0);
}

TEST_CASE("pi: a group of a variable that is not there is refused by name", "[pi][domain]") {
    REQUIRE_THROWS_AS(value_of(named(named_groups(0.3), "reynolds"), first(6)), InvalidParameter);
    REQUIRE_THROWS_WITH(value_of(named(named_groups(0.3), "reynolds"), first(6)),
                        Catch::Contains("\"fluid_density\""));
}
