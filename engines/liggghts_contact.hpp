// SPDX-License-Identifier: MIT
// Our contact rules in the words of LIGGGHTS-PUBLIC 3.8.0 (docs/export.md says where they differ):
//   normal hertz          Hertz, with Tsuji's dashpot from the restitution
//   tangential history    Mindlin, k_t = 8 G* a, without the rescaling of the spring where the contact shrinks
//   rolling_friction epsd EPSD: k_r = 9/4 k_n (mu_r R*)^2, critically damped where coeffRollVisc is 1
//   cohesion sjkr         no JKR: an energy density times the area of overlap
// LIGGGHTS makes E* and G* of a pair from the materials of the two: these are the materials that give the pair's own.
#pragma once

#include "engines/deck.hpp"
#include "rigs/physics.hpp"

#include <string>
#include <vector>

namespace engines {

struct Elastic {
    double youngs_modulus, poisson_ratio;  // Pa, 1
};

// Of which two of a kind have this E* and G*.
Elastic material_of_pair(double e_star, double g_star);
// Which against `grain` has this E* and G*.
Elastic material_against(const Elastic& grain, double e_star, double g_star);

// J/m^3 of sjkr, whose deepest tension is then the pull-off force of JKR with this work of adhesion, 3/2 pi w R*; at this R* alone.
double sjkr_density(double work_of_adhesion, double r_star, double e_star);

// The rules of a deck with grains, glued grains and walls, types 1 to 3; `d` is the nominal diameter, at which cohesion meets its
// pull-off force.
struct LiggghtsRules {
    std::vector<std::string> properties;  // lines `fix ... property/global`
    std::string model;                    // what follows `pair_style gran` and `fix wall/gran`
    std::string
        moduli;  // a line that lets LIGGGHTS take a modulus outside 5e6 to 1e9 Pa; may be empty
};
LiggghtsRules liggghts_rules(const rigs::ContactParameters& grains,
                             const rigs::ContactParameters& walls, double d);

// Throws scaling::InvalidInput below 0.05, which LIGGGHTS does not take.
void refuse_liggghts_restitution(double restitution, const DeckOptions&);

}  // namespace engines
