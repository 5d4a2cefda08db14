// SPDX-License-Identifier: MIT
#include "engines/bed_liggghts.hpp"

#include "engines/bed_lammps.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace engines {

namespace {

// SJKR is an energy density [J/m^3] over the area of overlap; no value of it is JKR's. It is there
// so that the term is computed.
constexpr double cohesion_energy_density = 3000.0;

std::string deck(const Bed& b) {
    return fmt::format(
               R"(# The bed of similitude bench in LIGGGHTS: Hertz, Mindlin, SJKR, CDT rolling.
# Material 1 are the grains, material 2 is the base.
units si
atom_style granular
atom_modify map array
boundary p p f
newton off
communicate single vel yes
# The bed is cut upright, so that every rank has as many grains as another.
processors * * 1
read_data bed.data
neighbor {margin} bin
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype {E} {E}
fix m2 all property/global poissonsRatio peratomtype {nu} {nu}
fix m3 all property/global coefficientRestitution peratomtypepair 2 {e} {ew} {ew} {ew}
fix m4 all property/global coefficientFriction peratomtypepair 2 {mu} {muw} {muw} {muw}
fix m5 all property/global coefficientRollingFriction peratomtypepair 2 {mur} 0 0 0
fix m6 all property/global cohesionEnergyDensity peratomtypepair 2 {k} 0 0 0
pair_style gran model hertz tangential history cohesion sjkr rolling_friction cdt
pair_coeff * *
timestep {dt}
fix base all wall/gran model hertz tangential history primitive type 2 zplane 0.0
fix weight all gravity {g} vector {dx} {dy} {dz}
fix move all nve/sphere
)",
               fmt::arg("E", b.youngs_modulus), fmt::arg("nu", b.poisson_ratio),
               fmt::arg("e", b.restitution), fmt::arg("ew", b.wall_restitution),
               fmt::arg("mu", b.sliding_friction), fmt::arg("muw", b.wall_friction),
               fmt::arg("mur", b.rolling_friction), fmt::arg("k", cohesion_energy_density),
               fmt::arg("margin", b.margin), fmt::arg("dt", b.time_step), fmt::arg("g", b.gravity),
               fmt::arg("dx", b.downward.x), fmt::arg("dy", b.downward.y),
               fmt::arg("dz", b.downward.z)) +
           timed_runs(b);
}

const std::string begins = "LIGGGHTS (Version ";  // the first line of its output

}  // namespace

BedEngine liggghts() {
    return {.name = "liggghts",
            .title = "LIGGGHTS",
            .program = "liggghts",
            .package = "liggghts",
            .laws = "Hertz, Mindlin with history, SJKR, CDT rolling, Tsuji's dashpots",
            .differs =
                "another and cheaper adhesion (SJKR) and rolling resistance (CDT): the same "
                "bed, not the same physics",
            .deck =
                [](const Bed& b) {
                    return std::vector<DeckFile>{{"bed.in", deck(b)},
                                                 {"bed.data", positions_data(b, 2)}};
                },
            .command = [](int threads) { return lammps_like_command("liggghts", threads); },
            .read =
                [](const Bed& b, const std::string& output) {
                    BedFigures f = read_lammps_like(b, output, begins);
                    // "LIGGGHTS (Version NAME NUMBER, compiled WHEN by WHOM, git commit WHICH)"
                    f.version = f.version.substr(0, f.version.find(','));
                    f.version.erase(0, std::min(begins.size(), f.version.size()));
                    return f;
                }};
}

}  // namespace engines
