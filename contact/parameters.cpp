// SPDX-License-Identifier: MIT
// The doors from units to numbers, one per law, and the rules that their parameters obey.
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
#include "contact/rolling_edem_standard.hpp"
#include "contact/rolling_epsd.hpp"
#include "contact/rolling_rvd.hpp"
#include "contact/rolling_sds.hpp"
#include "contact/scale_free.hpp"
#include "contact/twisting_marshall2009.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

namespace contact {
namespace {

void require(bool holds, const char* where, double value, const char* unit, const char* rule,
             const char* remedy) {
    if (holds) return;
    const std::string given = fmt::format("{}{}{}", value, *unit ? " " : "", unit);
    throw scaling::InvalidParameter(scaling::mistake(where, given, rule, remedy));
}

// Returns the value, so that a law is built in one expression.
double positive(double value, const char* where, const char* unit, const char* remedy) {
    require(std::isfinite(value) && value > 0.0, where, value, unit, "must be > 0", remedy);
    return value;
}

double not_negative(double value, const char* where, const char* unit, const char* remedy) {
    require(std::isfinite(value) && value >= 0.0, where, value, unit, "must be >= 0", remedy);
    return value;
}

constexpr const char* modulus_remedy =
    "powders have 1e6 to 1e12 Pa; soften the grain if the step is short";

double friction(double value, const char* where) {
    return not_negative(value, where, "", "a coefficient, 0 for none");
}

void check_elasticity(const Material& m) {
    positive(m.youngs_modulus.value(), "Material.youngs_modulus", "Pa", modulus_remedy);
    require(m.poisson_ratio > -1.0 && m.poisson_ratio <= 0.5, "Material.poisson_ratio",
            m.poisson_ratio, "", "must be > -1 and <= 0.5", "0.2 to 0.35 for most solids");
}

}  // namespace

scaling::Pressure e_star(const Material& i, const Material& j) {
    check_elasticity(i);
    check_elasticity(j);
    return 1.0 / ((1.0 - i.poisson_ratio * i.poisson_ratio) / i.youngs_modulus +
                  (1.0 - j.poisson_ratio * j.poisson_ratio) / j.youngs_modulus);
}

scaling::Pressure g_star(const Material& i, const Material& j) {
    check_elasticity(i);
    check_elasticity(j);
    return 0.5 / ((2.0 - i.poisson_ratio) * (1.0 + i.poisson_ratio) / i.youngs_modulus +
                  (2.0 - j.poisson_ratio) * (1.0 + j.poisson_ratio) / j.youngs_modulus);
}

scaling::Mass sphere_mass(const Material& m, scaling::Length radius) {
    positive(m.density.value(), "Material.density", "kg/m^3", "of the solid, not of the bed");
    positive(radius.value(), "sphere_mass.radius", "m", "half the diameter");
    return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius * m.density;
}

Hertz Hertz::from(scaling::Pressure e_star) {
    return {.e_star = positive(e_star.value(), "Hertz.e_star", "Pa", modulus_remedy)};
}

Jkr Jkr::from(scaling::Pressure e_star, scaling::EnergyPerArea work_of_adhesion, TearOff tear_off) {
    return {.e_star = positive(e_star.value(), "Jkr.e_star", "Pa", modulus_remedy),
            .w = positive(work_of_adhesion.value(), "Jkr.work_of_adhesion", "J/m^2",
                          "w = 2 gamma for like solids; without adhesion the law is Hertz"),
            .tear_off = tear_off};
}

CapillaryBridge CapillaryBridge::from(scaling::EnergyPerArea surface_tension,
                                      scaling::Volume volume, double contact_angle) {
    const double gamma = positive(surface_tension.value(), "CapillaryBridge.surface_tension", "N/m",
                                  "water has 0.072; a dry powder has no bridge");
    const double v = positive(volume.value(), "CapillaryBridge.liquid_volume", "m^3",
                              "of one bridge; a dry powder has none");
    require(contact_angle >= 0.0 && contact_angle < 0.5 * std::numbers::pi,
            "CapillaryBridge.contact_angle", contact_angle, "rad", "must be >= 0 and below pi/2",
            "a liquid that does not wet pushes the grains apart");
    return {.pull_per_radius = 4.0 * std::numbers::pi * gamma * std::cos(contact_angle),
            .volume = v,
            .rupture_gap = (1.0 + 0.5 * contact_angle) * cube_root(v)};
}

Ageing Ageing::from(double rate, scaling::Time onset) {
    return {.rate = not_negative(rate, "Ageing.rate", "", "growth per decade, 0 for none"),
            .onset = positive(onset.value(), "Ageing.onset", "s",
                              "the age from which on decades count")};
}

DampingTsuji1992 DampingTsuji1992::from(double restitution) {
    require(restitution >= 0.0 && restitution <= 1.0, "DampingTsuji1992.restitution", restitution,
            "", "must be >= 0 and <= 1", "rebound speed over impact speed");
    const double l = std::abs(std::log(restitution));  // infinite at 0
    const double beta =
        restitution > 0.0 ? l / std::sqrt(l * l + std::numbers::pi * std::numbers::pi) : 1.0;
    return {.factor = 2.0 * std::sqrt(5.0 / 6.0) * beta};
}

DampingViscoelastic DampingViscoelastic::from(Eta eta, double tangential_ratio) {
    return {
        .eta = not_negative(eta.value(), "DampingViscoelastic.eta", "1/(m s)", "0 for none"),
        .tangential_ratio = not_negative(tangential_ratio, "DampingViscoelastic.tangential_ratio",
                                         "", "tangential over normal dashpot; 0 for none")};
}

DragSchiller1935 DragSchiller1935::from(double factor, scaling::Density density,
                                        scaling::Viscosity viscosity) {
    require(density.value() > 0.0 || viscosity.value() > 0.0, "DragSchiller1935.density",
            density.value(), "kg/m^3", "must be > 0 where the fluid has no viscosity",
            "air: 1.2 kg/m^3 and 1.8e-5 Pa s");
    return {.factor = not_negative(factor, "DragSchiller1935.factor", "", "1: the curve as it is"),
            .density = not_negative(density.value(), "DragSchiller1935.density", "kg/m^3",
                                    "of the fluid, not of the grain"),
            .viscosity = not_negative(viscosity.value(), "DragSchiller1935.viscosity", "Pa s",
                                      "dynamic: air 1.8e-5 Pa s, water 1e-3 Pa s")};
}

Mindlin Mindlin::from(scaling::Pressure g_star, double sliding_friction) {
    return {.g_star = positive(g_star.value(), "Mindlin.g_star", "Pa", modulus_remedy),
            .sliding_friction = friction(sliding_friction, "Mindlin.sliding_friction")};
}

Coulomb Coulomb::from(double sliding_friction) {
    return {.sliding_friction = friction(sliding_friction, "Coulomb.sliding_friction")};
}

TwistingMarshall2009 TwistingMarshall2009::from(scaling::Pressure g_star, double sliding_friction) {
    return {
        .g_star = positive(g_star.value(), "TwistingMarshall2009.g_star", "Pa",
                           "1/G* = sum 2 (2 - nu)(1 + nu)/E"),
        .sliding_friction = friction(sliding_friction, "TwistingMarshall2009.sliding_friction")};
}

RollingEpsd RollingEpsd::from(double rolling_friction, double damping_ratio) {
    return {.rolling_friction = friction(rolling_friction, "RollingEpsd.rolling_friction"),
            .damping_ratio = not_negative(damping_ratio, "RollingEpsd.damping_ratio", "",
                                          "1 is critical, 0 none")};
}

RollingSds RollingSds::from(scaling::Stiffness stiffness, scaling::Damping damping,
                            double rolling_friction) {
    return {.stiffness = positive(stiffness.value(), "RollingSds.stiffness", "N/m",
                                  "without a spring there is no rest; use RollingRvd"),
            .damping = not_negative(damping.value(), "RollingSds.damping", "kg/s", "0 for none"),
            .rolling_friction = friction(rolling_friction, "RollingSds.rolling_friction")};
}

RollingEdemStandard RollingEdemStandard::from(double rolling_friction) {
    return {.rolling_friction = friction(rolling_friction, "RollingEdemStandard.rolling_friction")};
}

RollingRvd RollingRvd::from(double rolling_friction) {
    return {.rolling_friction = friction(rolling_friction, "RollingRvd.rolling_friction")};
}

}  // namespace contact
