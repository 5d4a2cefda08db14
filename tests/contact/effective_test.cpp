// SPDX-License-Identifier: MIT
#include "contact/effective.hpp"

#include "scaling/errors.hpp"

#include <catch2/catch.hpp>

#include <numbers>

namespace si = boost::units::si;
using contact::Material;

namespace {

Material material(double youngs_modulus, double poisson_ratio) {
    return {youngs_modulus * si::pascals, poisson_ratio, 2500.0 * si::kilograms_per_cubic_meter};
}

}  // namespace

// By hand for two like bodies, with G = E/(2 (1 + nu)). 1e-15: a few roundings.
TEST_CASE("like spheres: E* = E/(2 (1 - nu^2)) and G* = G/(2 (2 - nu))", "[contact][exact]") {
    const double nu = GENERATE(0.0, 0.3, 0.5);
    const Material m = material(156e6, nu);
    const double g = 156e6 / (2.0 * (1.0 + nu));
    REQUIRE(contact::e_star(m, m).value() == Approx(78e6 / (1.0 - nu * nu)).epsilon(1e-15));
    REQUIRE(contact::g_star(m, m).value() == Approx(g / (2.0 * (2.0 - nu))).epsilon(1e-15));
}

// Rigid partner: only the soft body's own compliance is left. 1e-6 is the ratio of the two moduli.
TEST_CASE("against a rigid wall E* = E/(1 - nu^2)", "[contact][limit]") {
    const Material soft = material(2e6, 0.25), rigid = material(2e12, 0.3);
    REQUIRE(contact::e_star(soft, rigid).value() == Approx(2e6 / 0.9375).epsilon(2e-6));
    REQUIRE(contact::g_star(soft, rigid).value() == Approx(2e6 / 4.375).epsilon(2e-6));
}

// E_i/(1 - nu^2) = 2 GPa and 6 GPa give 1/(1/2 + 1/6) = 1.5 GPa; each body's own nu, not a mean.
TEST_CASE("unlike materials add their compliances", "[contact][exact]") {
    const Material i = material(2e9 * 0.96, 0.2), j = material(6e9 * 0.84, 0.4);
    REQUIRE(contact::e_star(i, j).value() == Approx(1.5e9).epsilon(1e-14));
    REQUIRE(contact::e_star(j, i).value() == Approx(1.5e9).epsilon(1e-14));
}

TEST_CASE("R* of equal spheres is R/2, and R at a wall, to the last bit", "[contact][exact]") {
    const double r = GENERATE(0.6e-6, 1.2e-4, 3.7e-2);
    REQUIRE(contact::r_star(r, r) == 0.5 * r);
    REQUIRE(contact::r_star(r, contact::wall_radius) == r);
    REQUIRE(contact::r_star(contact::wall_radius, r) == r);
    REQUIRE(contact::m_star(contact::wall_mass, r) == r);
    REQUIRE(contact::m_star(r, r) == 0.5 * r);
}

// 3 and 6 give 2; symmetric in the two grains without tolerance.
TEST_CASE("unequal spheres add the inverses of radius and mass", "[contact][exact]") {
    REQUIRE(contact::r_star(3e-4, 6e-4) == Approx(2e-4).epsilon(1e-15));
    REQUIRE(contact::m_star(0.7, 0.3) == Approx(0.21).epsilon(1e-15));
    REQUIRE(contact::r_star(1.7e-4, 5.3e-4) == contact::r_star(5.3e-4, 1.7e-4));
}

// 6 mm in diameter, 2500 kg/m^3: 4/3 pi (3e-3)^3 2500 = 9e-5 pi kg.
TEST_CASE("the mass of a sphere is its density times 4/3 pi R^3", "[contact][exact]") {
    const scaling::Mass mass = contact::sphere_mass(material(1e9, 0.3), 3e-3 * si::metres);
    REQUIRE(mass.value() == Approx(9e-5 * std::numbers::pi).epsilon(1e-14));
}
