// SPDX-License-Identifier: MIT
// The rig `pile`: a heap poured on a limited base; what falls off is gone (docs/pile.md, docs/case.md).
// Three stages, each plain data: conditions as the case states them, a setup of SI doubles that an engine can run (and that a
// scale map can scale to the last bit), and the record of a run.
#pragma once

#include "cases/case.hpp"
#include "dem_min/clump.hpp"
#include "dem_min/mesh.hpp"
#include "dem_min/simulation.hpp"
#include "rigs/angle_of_repose.hpp"
#include "rigs/formed.hpp"
#include "rigs/heap.hpp"
#include "rigs/physics.hpp"
#include "rigs/stand.hpp"
#include "scaling/scale_map.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rigs {

enum class Base { flat, flat_with_rim, glued_grains };

struct Funnel {
    double outlet_diameter, top_diameter, height, outlet_height;  // m
};

struct PileConditions {
    Base base;
    double base_diameter, rim_height;  // m
    int grains;
    double drop_height, feed_diameter;          // m
    double feed_rate;                           // grains per second
    std::optional<Funnel> funnel;               // instead of the feed disc
    std::vector<dem_min::Surface> meshes = {};  // walls beside those above
};

// From an experiment of the rig `pile`, defaults filled in: drop_height 5 d, feed_diameter 6 d, feed_rate such that the stream
// is 5 % dense where it meets the base. Throws scaling::InvalidInput.
PileConditions pile_conditions(const cases::Experiment&);

// Grains per second such that a twentieth of the stream is solid where it meets the base. d in m, gravity in m/s^2.
double default_feed_rate(const PileConditions&, double d, double gravity);

// The physics of two materials where it is not that of all other grains, or of all other grains and walls.
struct PairParameters {
    int grain,
        partner;  // numbers of cases/materials.hpp; the partner's is that of a grain, or of a wall
    bool at_wall;
    ContactParameters laws;
};

// Where not all is of one material. Empty lists: all grains of the grain's, all walls of the plate's.
struct Materials {
    std::vector<PairParameters> pairs;
    std::vector<int> of_grain;    // [grains]
    std::vector<double> density;  // kg/m^3, [materials]
    cases::WallMaterials of_wall;
};

// Everything that a run needs. `density` is that of the grain's material, `d` is the grain's nominal diameter.
struct PileSetup {
    PileConditions conditions;
    double d, density;  // m, kg/m^3
    double gravity;     // m/s^2, along down(stand)
    ContactParameters grains, walls;
    Materials materials = {};
    double time_step, skin, lost_below;  // s, m, m
    double rest_duration;                // s, sqrt(1000 d/g)
    double longest;                      // s: a run that has not come to rest by then is given up
    std::vector<double> feed_time;       // s, [grains]
    std::vector<double> feed_x, feed_y;  // m, [grains]
    std::vector<double> radius;          // m, [grains]; of clumps that of a sphere as large
    // Length over width of the grains. Above 1 they are clumps of spheres (dem_min/clump.hpp), which appear lying along `feed_axis`.
    double aspect_ratio = 1.0;
    std::vector<contact::Vec3> feed_axis = {};  // 1, [grains]; empty: spheres
    double sleep_speed = 0.0;  // m/s: regions whose grains are all slower are left out; 0: none
    std::vector<std::string> notes = {};  // on the apparatus: open edges of a mesh and the like
    Stand stand = {};                     // of the base, and of what else stands on it
    dem_min::Fluid fluid = {};            // at rest in the room
};

// The material and the model of a case with the conditions of one of its experiments; feeding places and sizes drawn from
// `seed`. The time step is the shortest of dem_min::step_limits. Throws scaling::InvalidInput where the model holds physics
// that this core has not.
PileSetup pile_setup(const cases::Case&, const cases::Experiment&, std::uint64_t seed);

// Sets time step, skin, rest duration and give-up time from the rest of the setup.
void choose_steps(PileSetup&);

// Where simulate --sleep lets a region sleep: all grains slower than a thousandth of sqrt(g d), about the speed at which the whole
// heap counts as at rest. m/s.
double speed_of_rest(const PileSetup&);

// What a grain of nominal diameter `d` is made of: a sphere is a clump of one.
dem_min::Clump grain_of(const PileSetup&, double d, double density);

// Spheres of a grain: 1, or those of a clump.
std::size_t spheres_per_grain(const PileSetup&);

// Draws feeding instants, places, directions of clumps, sizes and, where sizes have materials of their own, these. `size_spread`:
// see draw_grain.
void choose_feed(PileSetup&, const cases::Grain& sizes, std::uint64_t seed,
                 double size_spread = 0.0);

// The fluid, the tilt and the vibration that the model names (rigs/pile_surroundings.cpp). Conditions and densities must be there.
void choose_surroundings(PileSetup&, const cases::Case&, const cases::Experiment&);

double shaking_strength(const PileSetup&);  // 1, A omega^2/g: above 1 grains leave the base

// Densities and pairs of what the feed has drawn (rigs/pile_materials.cpp). `s.grains` and `s.walls` must be there.
void choose_materials(PileSetup&, const cases::Case&, const cases::Experiment&);

// The rules that LAMMPS has as well, at every contact of the pile (rigs/physics.hpp).
void take_lammps_rules(PileSetup&);

// The same setup in the units of the scaled system: every double times the factor of its quantity. Where the factors are powers
// of two the result is exact, and so are all the bits of the run.
PileSetup scaled(const PileSetup&, const scaling::ScaleMap&);

// Grains times steps: asked for, and left out of that by sleep.
struct GrainSteps {
    std::int64_t asked = 0, slept = 0;
    double share_slept() const {
        return asked > 0 ? static_cast<double>(slept) / static_cast<double>(asked) : 0.0;
    }
};

// A run between two pauses.
struct PileRun {
    dem_min::Simulation simulation;
    std::size_t fed = 0;            // grains that have appeared
    std::int64_t still_since = -1;  // step since which the heap has been at rest; -1: moving
    bool finished = false, at_rest = false;
    GrainSteps while_fed{};  // of `work` so far, what fell before the last grain was due
    GrainSteps work() const {
        return {simulation.past.grain_steps, simulation.past.grain_steps_slept};
    }
};

PileRun begin_pile(const PileSetup&, int threads, bool ledger = false);

// Goes on for at most `steps`, fewer if the run finishes. Deterministic: the number of calls does not matter.
void advance(PileRun&, const PileSetup&, std::int64_t steps);

// What the run is expected to need, for progress: steps until the last grain is fed and the heap has been still long enough.
std::int64_t expected_steps(const PileSetup&);

struct PileRecord {
    Heap heap;  // without what a funnel still holds
    bool at_rest;
    Formed formed;
    std::vector<std::pair<Estimator, std::optional<Angle>>> angles;
    RadialProfile profile;
    std::optional<double> packing_fraction;
    double coordination;
    std::int64_t grains_fed, grains_lost, grains_in_funnel, steps;  // a clump is one grain
    double aspect_ratio;                                            // of the grains
    GrainSteps work, work_while_fed;
    double time_step;                    // s
    double base_radius, grain_diameter;  // m
    std::uint64_t hash;                  // of the final state in the setup's own units
    std::vector<std::string> notes;      // on the apparatus, for the reader of the result
};

PileRecord record(const PileRun&, const PileSetup&);

}  // namespace rigs
