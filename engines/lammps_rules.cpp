// SPDX-License-Identifier: MIT
#include "engines/lammps_rules.hpp"

#include "contact/damping_tsuji1992.hpp"
#include "engines/bed_lammps.hpp"
#include "engines/pile_feed.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace engines {
namespace {

constexpr double most_damping = 0.12;  // e below which the polynomial of `tsuji` ends

bool later(const DeckOptions& o) { return o.lammps == LammpsRelease::later; }

bool sticky(const rigs::ContactParameters& c) { return c.work_of_adhesion > 0.0; }

// 17 digits: every double comes back as it was.
std::string normal(const rigs::ContactParameters& c, double damping) {
    const double young = 2.0 * c.e_star;
    return sticky(c) ? fmt::format("jkr {:.17g} {:.17g} 0 {:.17g}", young, damping,
                                   0.5 * c.work_of_adhesion)
                     : fmt::format("hertz/material {:.17g} {:.17g} 0", young, damping);
}

}  // namespace

NominalPair nominal_pair(double d, double density) {
    return {0.25 * d, 0.5 * density * (std::numbers::pi / 6.0) * (d * d * d)};
}

double viscoelastic_eta(const rigs::ContactParameters& c, const NominalPair& pair) {
    const double a0 = std::cbrt(4.5 * std::numbers::pi * c.work_of_adhesion * pair.r_star *
                                pair.r_star / c.e_star);
    const auto dashpot = contact::DampingTsuji1992::from(c.restitution);
    return dashpot.normal(c.e_star, a0, pair.m_star) / (a0 * pair.m_star);
}

std::string granular_arguments(const rigs::ContactParameters& c, const DeckOptions& o,
                               const NominalPair& pair) {
    std::string text;
    if (!later(o))
        text = normal(c, restitution_to_tell(c.restitution)) + " damping tsuji";
    else if (sticky(c))
        text = normal(c, viscoelastic_eta(c, pair)) + " damping viscoelastic";
    else
        text = normal(c, c.restitution) + " damping coeff_restitution";
    // Tsuji's dashpots go with the root of the stiffness, 2 E* a and 8 G* a.
    text += fmt::format(" tangential mindlin_rescale {:.17g} {:.17g} {:.17g}", 8.0 * c.g_star,
                        2.0 * std::sqrt(c.g_star / c.e_star), c.sliding_friction);
    if (c.rolling_friction > 0.0 && c.as_lammps)
        text += fmt::format(" rolling sds {:.17g} {:.17g} {:.17g}", c.as_lammps->rolling_stiffness,
                            c.as_lammps->rolling_damping, c.rolling_friction);
    if (sticky(c)) text += " twisting marshall";
    return text;
}

void refuse_restitution(double restitution, const DeckOptions& o) {
    if (later(o) && !(restitution > 0.0))
        refuse(o, "lammps", "cannot damp at a restitution of 0 (damping coeff_restitution)",
               "take a higher restitution, or leave the option out");
    if (!later(o) && restitution < most_damping)
        refuse(o, "lammps", "cannot damp below a restitution of 0.12 (damping tsuji ends there)",
               "take a higher restitution, or leave the option out");
}

void refuse_contacts(const rigs::ContactParameters& grains, const rigs::ContactParameters& walls,
                     const DeckOptions& o, const std::optional<std::string>& smooth_walls) {
    if (o.nearest)
        refuse(o, "lammps", "has the laws of --contact lammps: no nearest is needed",
               "say --contact lammps");
    if (!grains.as_lammps &&
        (sticky(grains) || grains.rolling_friction > 0.0 || walls.rolling_friction > 0.0))
        refuse(o, "lammps", "has no EPSD rolling and does not tear off at the fold",
               "say --contact lammps: SDS rolling and tear-off at the deepest tension, on either "
               "engine");
    if (smooth_walls && sticky(walls))
        refuse(o, "lammps", "loses the force of an adhesive contact with a wall beyond its fold",
               *smooth_walls);
    refuse_contacts_of_our_own(grains, o, "lammps");
    refuse_restitution(grains.restitution, o);
    if (smooth_walls) refuse_restitution(walls.restitution, o);
}

std::string release_line(const DeckOptions& o) {
    return later(o) ? "# Written from the LAMMPS manual of 2 Sep 2026: UNTESTED, no such release "
                      "ran it. "
                      "Releases without damping coeff_restitution refuse it.\n"
                    : "# Written for and run with LAMMPS of 29 Sep 2021.\n";
}

std::string untested(const DeckOptions& o, bool adhesive) {
    if (!later(o)) return "";
    std::string text =
        "the deck is in the syntax of later LAMMPS releases, written from the manual and untested";
    if (adhesive)
        text +=
            "; its dashpots under JKR are viscoelastic (eta a m*), the case's for two nominal "
            "grains without load, weaker in a looser and stronger in a tighter contact";
    return text;
}

}  // namespace engines
