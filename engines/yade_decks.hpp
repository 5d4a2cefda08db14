// SPDX-License-Identifier: MIT
// The rigs `pile`, `drop`, `incline` and `impact` in Yade 2023.02a, as Python scripts (docs/export.md):
//   Law2_ScGeom_MindlinPhys_Mindlin   Hertz without tension, k_t = 8 G* a, without rescaling where the contact shrinks
//   en, es                            betan, betas by Thornton's fit for a contact that ends at no force
//   includeAdhesion                   no JKR: DMT, a constant pull of 4 pi gamma R* that ends at touch
//   includeMoment                     a spring of a given stiffness and a slider, no dashpot
#pragma once

#include "engines/liggghts_contact.hpp"
#include "engines/one_throw.hpp"

#include <string>
#include <vector>

namespace engines {

// deck.py, base.txt (x y z radius) and feed.txt (t x y radius). Throws scaling::InvalidInput for what Yade has not or is not told of:
// JKR and rolling resistance (unless the nearest is asked for), rigid friction, any base but glued grains, several materials, a
// funnel or mesh, sleep.
Deck yade_pile(const rigs::PileSetup&, const DeckOptions& = {});

// deck.py, start.txt (x y z vx vy vz spin radius density) and, for a drop or an incline, rows.txt. Throws as Throw does.
Deck yade_one_grain(const cases::Case&, const cases::Experiment&, const rigs::Ordinates&,
                    const DeckOptions& = {});

// J/m^2, gamma of DMT whose pull-off force is that of JKR with this work of adhesion: 4 pi gamma R* = 3/2 pi w R*.
double dmt_gamma(double work_of_adhesion);

std::vector<std::string> yade_command(const std::string& program, int ranks);
std::string yade_release(const std::string& output);
// The last line that names an error, or the last one.
std::string yade_complaint(const std::string& output);

// What all scripts share: the material, and the engines of a step; `laws` are the arguments of Ip2 and Law2.
struct YadeLaws {
    Elastic material;
    double sliding_friction, density;
    std::string ip2, law2;
};
YadeLaws yade_laws(const rigs::ContactParameters&, double density);
std::string yade_material(const YadeLaws&);

}  // namespace engines
