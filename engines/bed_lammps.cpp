// SPDX-License-Identifier: MIT
#include "engines/bed_lammps.hpp"

#include "engines/output.hpp"
#include "engines/process.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <sstream>

namespace engines {

namespace {

// Of a dashpot alpha sqrt(m k), k = 4/3 E* a, by the restitution e of a Hertz pair: the fit that LAMMPS uses (Tsuji, Tanaka &
// Ishida 1992, as in the manual of pair_style granular).
double fitted_alpha(double e) {
    double sum = 0.0;
    for (const double c : {4.8218, -18.022, 27.467, -22.348, 11.087, -4.2783, 1.2728})
        sum = sum * e + c;
    return sum;
}

// The same in closed form (Antypov & Elliott 2011): sqrt 5 beta.
double exact_alpha(double e) {
    const double log_e = std::log(e);
    return -std::sqrt(5.0) * log_e / std::sqrt(log_e * log_e + std::numbers::pi * std::numbers::pi);
}

std::string deck(const Bed& b) {
    return fmt::format(
               R"(# The bed of similitude bench in LAMMPS: JKR, Mindlin with history, SDS rolling.
units si
atom_style sphere
boundary p p f
newton off
comm_modify vel yes
# The bed is cut upright, so that every rank has as many grains as another.
processors * * 1
read_data bed.data
pair_style granular
pair_coeff * * jkr {E} {e} {nu} {gamma} tangential mindlin NULL 1.0 {mu} &
    rolling sds {kr} {gr} {mur} twisting none damping tsuji
neighbor {margin} bin
neigh_modify delay 0 every 1 check yes
fix move all nve/sphere
fix weight all gravity {g} vector {dx} {dy} {dz}
fix base all wall/gran granular hertz/material {E} {ew} {nu} &
    tangential mindlin NULL 1.0 {muw} damping tsuji zplane 0.0 NULL
timestep {dt}
)",
               fmt::arg("E", b.youngs_modulus), fmt::arg("e", restitution_to_tell(b.restitution)),
               fmt::arg("nu", b.poisson_ratio), fmt::arg("gamma", b.surface_energy),
               fmt::arg("mu", b.sliding_friction), fmt::arg("kr", b.rolling_stiffness),
               fmt::arg("gr", b.rolling_damping), fmt::arg("mur", b.rolling_friction),
               fmt::arg("margin", b.margin), fmt::arg("g", b.gravity), fmt::arg("dx", b.downward.x),
               fmt::arg("dy", b.downward.y), fmt::arg("dz", b.downward.z),
               fmt::arg("ew", restitution_to_tell(b.wall_restitution)),
               fmt::arg("muw", b.wall_friction), fmt::arg("dt", b.time_step)) +
           timed_runs(b);
}

}  // namespace

double restitution_to_tell(double e) {
    double low = 0.0, high = 1.0;  // its alpha is larger, or smaller, than that of e
    for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        (fitted_alpha(middle) > exact_alpha(e) ? low : high) = middle;
    }
    return 0.5 * (low + high) < 1e-12 ? 0.0 : 0.5 * (low + high);
}

std::vector<std::string> lammps_like_command(const std::string& program, int threads) {
    std::vector<std::string> argv = mpirun(threads);
    for (const char* word : {program.c_str(), "-log", "none", "-in", "bed.in"})
        argv.emplace_back(word);
    return argv;
}

// The contacts are counted in a run of no steps, so that the timed one does nothing else.
std::string timed_runs(const Bed& b) {
    return fmt::format(R"(thermo 1000000
compute touching all contact/atom
compute touched all reduce sum c_touching
compute spin all erotate/sphere
run {}
run {}
thermo_style custom step atoms ke c_spin c_touched
run 0
variable neighbours equal c_touched/atoms
variable kinetic equal ke+c_spin
print "bed: grains $(atoms) neighbours ${{neighbours}} kinetic ${{kinetic}}"
)",
                       b.warm_up, b.steps);
}

BedFigures read_lammps_like(const Bed& bed, const std::string& output,
                            const std::string& version_at) {
    BedFigures f;
    bool timed = false, counted = false;
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);) {
        double seconds = 0.0;
        int ranks = 0, steps = 0;
        if (std::sscanf(line.c_str(), "Loop time of %lf on %d procs for %d steps", &seconds, &ranks,
                        &steps) == 3 &&
            steps == bed.steps) {
            f.seconds = seconds;
            timed = true;
        }
        counted = read_bed_line(line, f) || counted;
        if (f.version.empty() && line.rfind(version_at, 0) == 0) f.version = line;
    }
    if (!timed || !counted) throw_unreadable(output);
    return f;
}

BedEngine lammps() {
    return {
        .name = "lammps",
        .title = "LAMMPS",
        .program = "lmp",
        .package = "lammps",
        .laws = "JKR, Mindlin with history, SDS rolling, Tsuji's dashpots",
        .differs = "",
        .deck =
            [](const Bed& b) {
                return std::vector<DeckFile>{{"bed.in", deck(b)},
                                             {"bed.data", positions_data(b, 1)}};
            },
        .command = [](int threads) { return lammps_like_command("lmp", threads); },
        .read = [](const Bed& b,
                   const std::string& output) { return read_lammps_like(b, output, "LAMMPS ("); }};
}

}  // namespace engines
