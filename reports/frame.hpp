// SPDX-License-Identifier: MIT
// One instant of a simulation in the formats that other programs open (docs/simulate.md). SI
// throughout, nothing rounded: text carries as many digits as give back the same double.
#pragma once

#include "rigs/frame.hpp"

#include <ostream>
#include <string>
#include <vector>

namespace reports {

using rigs::Frame;

// Text dump of LAMMPS (`dump custom`, units si): type 1 is loose, 2 fixed, or the types
// of the file that the grains come from. The first frame of a file
// says the units, as LAMMPS has it.
void write_lammps(std::ostream&, const Frame&, bool first);

// LAMMPS data for read_data under atom_style sphere, units si: diameters and densities, which follow from masses; ids and types as
// they are. Mass must be > 0, types >= 1.
void write_lammps_data(std::ostream&, const Frame&);

// x y z r, as Yade's ymport.text takes it; nothing else of the frame.
void write_yade_text(std::ostream&, const Frame&);

// Extended XYZ; all grains are of the species X, which is no element.
void write_extxyz(std::ostream&, const Frame&);

// VTK PolyData, one vertex a grain, arrays as raw binary in this machine's byte order.
void write_vtp(std::ostream&, const Frame&);

// A ParaView collection: which file holds which instant.
struct TimedFile {
    double time;       // s
    std::string path;  // from the collection's own folder
};
void write_pvd(std::ostream&, const std::vector<TimedFile>&);

}  // namespace reports
