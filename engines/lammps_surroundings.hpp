// SPDX-License-Identifier: MIT
// What acts on a pile from afar, in LAMMPS' words: gravity that leans with the base, buoyancy, drag, and the inertial force of a base
// that shakes, in whose frame the deck is written as our own run is. A level base at rest without a fluid has one fix and plain z.
#pragma once

#include "rigs/pile.hpp"

#include <string>

namespace engines {

// Fixes of the group `loose`, and what they ask for. They want the compute `radius`, which may follow.
std::string lammps_forces_from_afar(const rigs::PileSetup&);

// How high above the base's mean place a grain is in the room: part of an atom-style variable.
std::string lammps_height(const rigs::PileSetup&);

// Whether a force across the plumb line acts, which nothing but a contact gives to a grain that falls from rest: an atom-style variable.
std::string lammps_pushed(const rigs::PileSetup&);

// Reads a batch ${up} higher in the room, and gives it the velocity of its fall, whose z component is its charge.
std::string lammps_reading(const rigs::PileSetup&);

// Moves the parked grains of the group `fresh`, `lift` m too high in the room, to ${up}, with that velocity.
std::string lammps_unparking(const rigs::PileSetup&, double lift);

}  // namespace engines
