// SPDX-License-Identifier: MIT
// Bad parameters throw, name themselves, and say the rule; good ones at the border pass.
#include "contact/ageing.hpp"
#include "contact/capillary_bridge.hpp"
#include "contact/coulomb.hpp"
#include "contact/damping_tsuji1992.hpp"
#include "contact/damping_viscoelastic.hpp"
#include "contact/drag_schiller1935.hpp"
#include "contact/effective.hpp"
#include "contact/hertz.hpp"
#include "contact/jkr.hpp"
#include "contact/mindlin.hpp"
#include "contact/no_rolling.hpp"
#include "contact/rolling_edem_standard.hpp"
#include "contact/rolling_epsd.hpp"
#include "contact/rolling_rvd.hpp"
#include "contact/rolling_sds.hpp"
#include "scaling/errors.hpp"

#include <catch2/catch.hpp>

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace si = boost::units::si;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

const auto pa = si::pascals;
const auto n_per_m = si::newtons_per_meter;
const auto kg_per_m3 = si::kilograms_per_cubic_meter;
const auto kg_per_s = si::newtons_per_meter * si::seconds;

contact::Material material(double youngs_modulus, double poisson_ratio, double density) {
    return {youngs_modulus * pa, poisson_ratio, density * si::kilograms_per_cubic_meter};
}

// One parameter of one law: how its law is made from it, and what it must not be.
struct Parameter {
    std::string name;
    std::function<void(double)> make;
    std::vector<double> refused, accepted;
};

std::vector<Parameter> parameters() {
    const std::vector<double> not_positive{0.0, -1.0, nan, infinite}, negative{-0.1, nan, infinite};
    const std::vector<double> positive{1e-3, 1e9}, not_negative{0.0, 0.5};
    const auto m3 = si::cubic_meters;
    const contact::Material good = material(1e9, 0.3, 2500.0);
    return {
        {"Hertz.e_star", [](double x) { contact::Hertz::from(x * pa); }, not_positive, positive},
        {"Jkr.e_star", [](double x) { contact::Jkr::from(x * pa, 0.1 * n_per_m); }, not_positive,
         positive},
        {"Jkr.work_of_adhesion", [](double x) { contact::Jkr::from(1e9 * pa, x * n_per_m); },
         not_positive, positive},
        {"DragSchiller1935.factor",
         [](double x) {
             contact::DragSchiller1935::from(x, 1.2 * kg_per_m3, 2e-5 * pa * si::seconds);
         },
         negative, not_negative},
        {"DragSchiller1935.density",
         [](double x) {
             contact::DragSchiller1935::from(1.0, x * kg_per_m3, 2e-5 * pa * si::seconds);
         },
         negative, not_negative},
        {"DragSchiller1935.density",
         [](double x) {
             contact::DragSchiller1935::from(1.0, x * kg_per_m3, 0.0 * pa * si::seconds);
         },
         {0.0},
         positive},
        {"DragSchiller1935.viscosity",
         [](double x) {
             contact::DragSchiller1935::from(1.0, 1.2 * kg_per_m3, x * pa * si::seconds);
         },
         negative, not_negative},
        {"DampingTsuji1992.restitution",
         [](double x) { contact::DampingTsuji1992::from(x); },
         {-0.1, 1.1, nan},
         {0.0, 0.5, 1.0}},
        {"DampingViscoelastic.eta",
         [](double x) { contact::DampingViscoelastic::from(x / (si::meters * si::seconds), 0.5); },
         negative, not_negative},
        {"DampingViscoelastic.tangential_ratio",
         [](double x) { contact::DampingViscoelastic::from(1e9 / (si::meters * si::seconds), x); },
         negative, not_negative},
        {"CapillaryBridge.surface_tension",
         [=](double x) { contact::CapillaryBridge::from(x * n_per_m, 1e-15 * m3, 0.0); },
         not_positive, positive},
        {"CapillaryBridge.liquid_volume",
         [=](double x) { contact::CapillaryBridge::from(0.07 * n_per_m, x * m3, 0.0); },
         not_positive, positive},
        {"CapillaryBridge.contact_angle",
         [=](double x) { contact::CapillaryBridge::from(0.07 * n_per_m, 1e-15 * m3, x); },
         {-0.1, 1.571, nan},
         {0.0, 1.57}},
        {"Ageing.rate", [](double x) { contact::Ageing::from(x, 1.0 * si::seconds); }, negative,
         not_negative},
        {"Ageing.onset", [](double x) { contact::Ageing::from(0.1, x * si::seconds); },
         not_positive, positive},
        {"Mindlin.g_star", [](double x) { contact::Mindlin::from(x * pa, 0.3); }, not_positive,
         positive},
        {"Mindlin.sliding_friction", [](double x) { contact::Mindlin::from(1e9 * pa, x); },
         negative, not_negative},
        {"Coulomb.sliding_friction", [](double x) { contact::Coulomb::from(x); }, negative,
         not_negative},
        {"RollingEpsd.rolling_friction", [](double x) { contact::RollingEpsd::from(x, 0.3); },
         negative, not_negative},
        {"RollingEpsd.damping_ratio", [](double x) { contact::RollingEpsd::from(0.1, x); },
         negative, not_negative},
        {"RollingSds.stiffness",
         [](double x) { contact::RollingSds::from(x * n_per_m, 0.1 * kg_per_s, 0.1); },
         not_positive, positive},
        {"RollingSds.damping",
         [](double x) { contact::RollingSds::from(1.0 * n_per_m, x * kg_per_s, 0.1); }, negative,
         not_negative},
        {"RollingSds.rolling_friction",
         [](double x) { contact::RollingSds::from(1.0 * n_per_m, 0.1 * kg_per_s, x); }, negative,
         not_negative},
        {"RollingEdemStandard.rolling_friction",
         [](double x) { contact::RollingEdemStandard::from(x); }, negative, not_negative},
        {"RollingRvd.rolling_friction", [](double x) { contact::RollingRvd::from(x); }, negative,
         not_negative},
        {"Material.youngs_modulus",
         [=](double x) { contact::e_star(good, material(x, 0.3, 2500.0)); }, not_positive,
         positive},
        {"Material.youngs_modulus",
         [=](double x) { contact::g_star(material(x, 0.3, 2500.0), good); }, not_positive,
         positive},
        {"Material.poisson_ratio",
         [=](double x) { contact::e_star(material(1e9, x, 2500.0), good); },
         {-1.0, 0.51, nan},
         {-0.9, 0.0, 0.5}},
        {"Material.poisson_ratio",
         [=](double x) { contact::g_star(good, material(1e9, x, 2500.0)); },
         {-1.0, 0.51, nan},
         {-0.9, 0.0, 0.5}},
        {"Material.density",
         [](double x) { contact::sphere_mass(material(1e9, 0.3, x), 1.0 * si::meters); },
         not_positive, positive},
        {"sphere_mass.radius", [=](double x) { contact::sphere_mass(good, x * si::meters); },
         not_positive, positive},
    };
}

}  // namespace

static_assert(contact::NormalLaw<contact::Hertz> && contact::NormalLaw<contact::Jkr>);
static_assert(contact::TangentialLaw<contact::Mindlin> && contact::TangentialLaw<contact::Coulomb>);
static_assert(contact::RollingLaw<contact::NoRolling> && contact::RollingLaw<contact::RollingEpsd>);
static_assert(contact::RollingLaw<contact::RollingSds> && contact::RollingLaw<contact::RollingRvd>);
static_assert(contact::RollingLaw<contact::RollingEdemStandard>);

TEST_CASE("a law refuses a parameter that is not physical, and names it", "[contact][domain]") {
    for (const Parameter& p : parameters()) {
        for (const double value : p.refused) {
            INFO(p.name << " = " << value);
            REQUIRE_THROWS_AS(p.make(value), scaling::InvalidParameter);
            REQUIRE_THROWS_WITH(p.make(value),
                                StartsWith(p.name + ": got ") && Contains("must be "));
        }
    }
}

TEST_CASE("a law takes every parameter up to the border of its range", "[contact][domain]") {
    for (const Parameter& p : parameters()) {
        for (const double value : p.accepted) {
            INFO(p.name << " = " << value);
            REQUIRE_NOTHROW(p.make(value));
        }
    }
}

TEST_CASE("the message gives value, unit, rule and remedy", "[contact][domain]") {
    REQUIRE_THROWS_WITH(contact::Jkr::from(1e9 * pa, -0.05 * n_per_m),
                        "Jkr.work_of_adhesion: got -0.05 J/m^2, must be > 0 (w = 2 gamma for like "
                        "solids; without adhesion the law is Hertz)");
}
