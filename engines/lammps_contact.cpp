// SPDX-License-Identifier: MIT
#include "engines/lammps_contact.hpp"

#include "contact/effective.hpp"

#include <fmt/format.h>

namespace engines {
namespace {

contact::Material material(const LammpsContact& c) {
    return {c.youngs_modulus * scaling::si::pascals, c.poisson_ratio, {}};
}

}  // namespace

double LammpsContact::e_star() const {
    return contact::e_star(material(*this), material(*this)).value();
}

double LammpsContact::g_star() const {
    return contact::g_star(material(*this), material(*this)).value();
}

// 17 digits: every double comes back as it was.
std::string granular_arguments(const LammpsContact& c) {
    std::string text = c.surface_energy > 0.0
                           ? fmt::format("jkr {:.17g} {:.17g} {:.17g} {:.17g}", c.youngs_modulus,
                                         c.eta, c.poisson_ratio, c.surface_energy)
                           : fmt::format("hertz/material {:.17g} {:.17g} {:.17g}", c.youngs_modulus,
                                         c.eta, c.poisson_ratio);
    const std::string stiffness =
        c.stiffness_as_number ? fmt::format("{:.17g}", 8.0 * c.g_star()) : "NULL";
    text += fmt::format(" damping viscoelastic tangential mindlin_rescale {} {:.17g} {:.17g}",
                        stiffness, c.tangential_ratio, c.sliding_friction);
    if (c.rolling_stiffness > 0.0)
        text += fmt::format(" rolling sds {:.17g} {:.17g} {:.17g}", c.rolling_stiffness,
                            c.rolling_damping, c.rolling_friction);
    if (c.twisting) text += " twisting marshall";
    return text;
}

dem_min::Laws laws(const LammpsContact& c) {
    dem_min::Laws result{contact::Hertz{c.e_star()},
                         contact::Mindlin{c.g_star(), c.sliding_friction}, contact::NoRolling{},
                         contact::DampingViscoelastic{c.eta, c.tangential_ratio}};
    result.friction_cap = contact::FrictionCap::total_plus_two_pull_off;
    if (c.surface_energy > 0.0) {
        result.normal =
            contact::Jkr{c.e_star(), c.work_of_adhesion(), contact::TearOff::max_tension};
        result.friction_cap = contact::FrictionCap::elastic_plus_two_pull_off;
    }
    if (c.rolling_stiffness > 0.0)
        result.rolling =
            contact::RollingSds{c.rolling_stiffness, c.rolling_damping, c.rolling_friction};
    if (c.twisting) result.twisting = {c.g_star(), c.sliding_friction};
    return result;
}

}  // namespace engines
