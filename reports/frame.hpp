// SPDX-License-Identifier: MIT
// One instant of a simulation in the formats that other programs open (docs/simulate.md). SI
// throughout, nothing rounded: text carries as many digits as give back the same double.
#pragma once

#include "contact/vec3.hpp"

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace reports {

// Shape of every array: [grains].
struct Frame {
    std::int64_t step = 0;
    double time = 0.0;             // s
    contact::Vec3 low, high;       // m: corners of a box that holds all grains
    std::vector<std::int64_t> id;  // from 1 (LAMMPS has no grain 0), never reused
    std::vector<contact::Vec3> position, velocity, spin;  // m, m/s, rad/s
    std::vector<double> radius, mass;                     // m, kg
    std::vector<std::uint8_t> fixed;                      // 1: glued, never moves

    std::size_t count() const { return id.size(); }
};

// Text dump of LAMMPS (`dump custom`, units si): type 1 is loose, 2 fixed. The first frame of a file
// says the units, as LAMMPS has it.
void write_lammps(std::ostream&, const Frame&, bool first);

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
