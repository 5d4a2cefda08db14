// SPDX-License-Identifier: MIT
// The rig `compression`: uniaxial compression of a powder, confined, then unconfined (docs/compression.md).
// A cell of square base stands on a plate and repeats itself in x and y. A piston comes down at one speed until it carries the
// consolidation stress, waits, and goes up until it carries nothing. Then the sides are cut free, the powder settles, and the
// piston crushes it. The largest stress on the way is the unconfined strength.
#pragma once

#include "dem_min/simulation.hpp"
#include "rigs/physics.hpp"
#include "scaling/scale_map.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace rigs {

// A cell and what is done in it. It does not know the grains, so that grains of another size are put in the same.
struct CompressionCell {
    double width, height;  // m, as it is filled
    double solid_volume;   // m^3
    double stress;         // Pa, of consolidation
    double speed;          // m/s, of the piston
    double crush_strain;   // 1, at which crushing ends
    double pause;          // s, after consolidation and after the sides are cut free
};

struct CompressionSetup {
    CompressionCell cell;
    double d, density;  // m, nominal; kg/m^3
    double gravity;     // m/s^2, along -z
    ContactParameters grains, plates;
    double time_step, skin;            // s, m
    std::vector<contact::Vec3> place;  // m, [grains], at the beginning
    std::vector<double> radius;        // m, [grains]
};

// Grains of diameters spread evenly by 20 % to either side of `d`, which fill `cell.solid_volume` to the last bit but rounding, at
// places drawn one after another where they touch nobody: random sequential addition, which a cell a third full still takes.
// `s` has all but places, radii, time step and skin. Throws scaling::InvalidParameter where the cell is fuller than that.
void fill_cell(CompressionSetup& s, std::uint64_t seed);

// The same setup in the units of the scaled system, cell and all; exact where the factors are powers of two.
CompressionSetup scaled(const CompressionSetup&, const scaling::ScaleMap&);

enum class Stage { compressing, holding, unloading, freed, crushing, done };
const char* to_string(Stage);

struct CompressionRow {
    Stage stage;
    double time;                         // s
    double strain;                       // 1, see CompressionRun::reference_height
    double piston_stress, floor_stress;  // Pa, elastic parts of the contacts over width^2
    double packing_fraction;  // 1, of the middle three fifths of the height; confined only
    double coordination;      // 1, contacts with grains per grain
};

struct CompressionRun {
    dem_min::Simulation simulation;  // wall 0: the floor, wall 1: the piston
    Stage stage = Stage::compressing;
    std::int64_t stage_since = 0;  // step
    double reference_height =
        0.0;  // m, of strain: as filled; while it is crushed, as it stood before
    std::vector<CompressionRow> rows;
    bool finished() const { return stage == Stage::done; }
};

CompressionRun begin_compression(const CompressionSetup&, int threads);

// At most `steps`, fewer if the run finishes. Deterministic: the number of calls does not matter.
void advance(CompressionRun&, const CompressionSetup&, std::int64_t steps);

// Steps that a run is expected to take, for progress: as if the powder were crushed at a packing fraction of a half.
std::int64_t expected_steps(const CompressionSetup&);

struct Strength {
    double stress, strain;  // Pa, 1: the largest of crushing, and where it was
};

struct CompressionRecord {
    std::vector<CompressionRow> rows;
    CompressionRow consolidated;  // when the consolidation stress was reached
    Strength strength;
    // (speed/height) d sqrt(density/stress) with height and stress at consolidation and at the strength: small is quasi-static.
    double inertial_number, inertial_number_of_crush;
    std::int64_t steps;
    std::uint64_t hash;  // of the final state in the setup's own units
};

CompressionRecord record(const CompressionRun&, const CompressionSetup&);

// N, elastic, of all contacts at a wall, along its normal into the room.
double elastic_force_on_grains(const dem_min::Simulation&, int wall);

// Solid share of a cell of that width between two heights.
double packing_between(const dem_min::Simulation&, double width, double low, double high);

// Contacts with other grains of a grain whose centre lies between two heights; 0 without one.
double coordination_between(const dem_min::Simulation&, double low, double high);

}  // namespace rigs
