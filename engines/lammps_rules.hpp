// SPDX-License-Identifier: MIT
// A case's contact in the words of LAMMPS' pair style `granular`. The moduli are told as E = 2 E* with nu = 0, which gives E* between
// grains and, by LAMMPS' own rule for walls, at a wall; k_t/a = 8 G* as a number.
//   29 Sep 2021   damping tsuji, told the restitution that gives the case's (restitution_to_tell). At a wall the number goes through
//                 the polynomial anew whenever a run is set up.
//   later         Hertz: damping coeff_restitution, 2 sqrt(5/6) beta sqrt(3/2 k m*) with k = F/overlap = 4/3 E* a: the case's own
//                 dashpot (manual of 4 Jul and 2 Sep 2026, "Models for normal damping in granular interactions"). `tsuji` has
//                 a factor sqrt 2 there that earlier releases have not, and is not used.
//                 JKR: neither is compatible with it (same page). damping viscoelastic, eta a m*, has the case's dashpot at one
//                 radius: that of two nominal grains without load.
#pragma once

#include "engines/deck.hpp"
#include "rigs/pile.hpp"

#include <optional>
#include <string>

namespace engines {

// Two nominal grains.
struct NominalPair {
    double r_star, m_star;  // m, kg
};
NominalPair nominal_pair(double d, double density);

// What follows `pair_coeff * *`, and `granular` in `fix wall/gran` and `fix wall/gran/region`.
std::string granular_arguments(const rigs::ContactParameters&, const DeckOptions&,
                               const NominalPair&);

// eta of damping viscoelastic, 1/(m s), that is the case's dashpot at the radius without load, a0^3 = 9 pi w R*^2/(2 E*).
double viscoelastic_eta(const rigs::ContactParameters&, const NominalPair&);

// Throws scaling::InvalidInput below 0.12, where the polynomial of `tsuji` ends; for a later release at 0, of which coeff_restitution
// takes the logarithm.
void refuse_restitution(double restitution, const DeckOptions&);

// Throws scaling::InvalidInput for EPSD rolling, the fold, rules of our own, a restitution that cannot be told, and for DeckOptions::nearest,
// of which there is no need. `smooth_walls`: grains touch walls, and then these may not adhere; the remedy is told.
void refuse_contacts(const rigs::ContactParameters& grains, const rigs::ContactParameters& walls,
                     const DeckOptions&, const std::optional<std::string>& smooth_walls);

// A line of comment: which release a deck is written for.
std::string release_line(const DeckOptions&);

// What a user must know of a deck in the later syntax; empty for 2021. `adhesive`: it holds JKR.
std::string untested(const DeckOptions&, bool adhesive);

}  // namespace engines
