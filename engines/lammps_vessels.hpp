// SPDX-License-Identifier: MIT
// The vessels of the rigs `discharge`, `column` and `drum` in LAMMPS' words. Every surface is a fix of its own: where a grain touches two
// surfaces of one region, this release gives one the spring of the other.
//   a curved wall   R* = r/(1 - r/(2 R)) within a cylinder of radius R, where our own core has r
//   a round hole    a cone that is d/1000 deep, open at both ends: its rim is felt. A slot: two sheets side by side. Until t = 0 a lid
//                   lies in the outlet; over its seam a grain is carried twice
//   a tube          a cylinder open at both ends, which is felt from both sides and at its rims
//   a wall that spins drags, but its rolling resistance counts the grain's own spin
#pragma once

#include "engines/deck.hpp"
#include "rigs/flow.hpp"

#include <string>

namespace engines {

// In the words of the deck of lammps_flow.cpp: v_since, the steps since t = 0; the group `loose`; c_tip, where the highest grain ends, m;
// c_within, how many are in the vessel; ${moved}, at which step they last were not at rest.
struct VesselWords {
    std::string up;          // axis
    std::string processors;  // that ranks share out: not the axis up
    std::string walls;       // before the bed
    std::string let_go;      // at t = 0
    std::string watch;       // each 100 steps after it: jumps to `over`
};

// `rules`: what follows `granular` at a wall. Throws scaling::InvalidInput for outlets that LAMMPS has no region for.
VesselWords vessel_words(const rigs::FlowSetup&, const std::string& rules, const DeckOptions&);

// What LAMMPS does not do as the rig does, for the user; empty where there is nothing.
std::string vessel_note(const rigs::FlowSetup&);

// m: what is lower has left.
double gone_below(const rigs::FlowSetup&);

}  // namespace engines
