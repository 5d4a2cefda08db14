// SPDX-License-Identifier: MIT
// What the rigs `discharge`, `column` and `drum` share: grains are poured into a vessel, come to rest, and are let go at t = 0
// (docs/discharge.md, docs/column.md, docs/drum.md). As with piles there are three stages, each plain data: conditions, a setup
// of SI doubles that a scale map scales to the last bit, the record of a run.
#pragma once

#include "cases/case.hpp"
#include "cases/csv.hpp"
#include "dem_min/simulation.hpp"
#include "rigs/heap.hpp"
#include "rigs/physics.hpp"
#include "scaling/scale_map.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace rigs {

// A silo with a flat bottom, its axis x = y = 0, its bottom z = 0.
struct Silo {
    bool round;                         // a cylinder of diameter `width`, else a box
    double width, depth;                // m, along x and y
    bool round_outlet;                  // in the middle of the bottom
    double outlet_width, outlet_depth;  // m; of a round one both are the diameter
};

// A cylinder that stands on a plane, z = 0.
struct Column {
    double radius, height;  // m
    double lift_speed;      // m/s, of its wall; 0: the wall is gone at once
};

// A drum whose axis is z, from 0 to `length`; up is y.
struct Drum {
    double diameter, length;  // m
    double speed;             // rad/s, > 0: the wall goes towards positive x at the lowest point
    double fill;              // 1, share of the drum that the bed fills
};

using Vessel = std::variant<Silo, Column, Drum>;

// How much is poured: so many grains, or as many as reach `level` with some to spare, that are then struck off.
struct Filling {
    int grains;    // 0: by `solid_volume`
    double solid;  // m^3
    double level;  // m; 0: nothing is struck off
};

struct FlowSetup {
    Vessel vessel;
    Filling filling;
    double d, density;  // m, nominal; kg/m^3
    double gravity;     // m/s^2
    ContactParameters grains, walls;
    double time_step, skin;            // s, m
    double rest_duration, longest;     // s; a bed that has not come to rest by then is given up
    std::vector<contact::Vec3> place;  // m, [grains], where they begin to fall
    std::vector<double> radius;        // m, [grains]
    double every;                      // s, between two looks, where `times` has none
    std::vector<double> times;         // s, of the looks, rising; then the run ends with the last
    std::vector<std::vector<double>> spots;  // m, [times], r of the profiles asked for; or empty
    std::vector<double> depths;  // m, at which a drum's velocities are asked for; or empty
};

// Whether the rig is one of these three.
bool is_flow(const cases::Experiment&);

// The material and the model of a case with the conditions of one of its experiments, of rig `discharge`, `column` or `drum`.
// Where there is a recording, it is looked at its instants. Throws scaling::InvalidInput.
FlowSetup flow_setup(const cases::Case&, const cases::Experiment&, std::uint64_t seed);

// The rules that LAMMPS has as well, at every contact (rigs/physics.hpp).
void take_lammps_rules(FlowSetup&);

// Draws sizes and places, then chooses steps: what flow_setup does once all else is known. Throws scaling::InvalidParameter where
// the vessel has no room.
void pour(FlowSetup&, const cases::Grain& sizes, std::uint64_t seed);

// The same setup in the units of the scaled system; exact where the factors are powers of two.
FlowSetup scaled(const FlowSetup&, const scaling::ScaleMap&);

// What a run remembers beside its grains and walls.
struct FlowState {
    std::int64_t still_since = -1;  // step since which the bed has been at rest; -1: moving
    std::int64_t released = -1;     // step of t = 0; -1: not yet
    std::int64_t last_out = -1;     // step at which a grain was last seen to have left a silo
    bool levelled = false, finished = false;
    std::string ending;  // one word; empty until it is finished
    std::size_t looked = 0;
    std::vector<std::vector<double>> rows;  // [rows][channels]
    std::map<std::string, double> noted;    // SI, for the record
};

struct FlowRun {
    dem_min::Simulation simulation;
    FlowState state;
};

FlowRun begin_flow(const FlowSetup&, int threads);

// Walls as they are after t = 0, which a checkpoint does not hold all of: for a run that goes on from one with `state`.
void restore(FlowRun&, const FlowSetup&, FlowState state);

// At most `steps`, fewer if the run finishes. Deterministic: the number of calls does not matter.
void advance(FlowRun&, const FlowSetup&, std::int64_t steps);

// What another engine saw of a flow.
struct FlowSight {
    std::int64_t step;
    std::vector<dem_min::Grain> grains;  // all that are in the vessel
};
struct SeenFlow {
    bool released;  // else the one sight is of a bed that did not come to rest
    std::int64_t still_since = -1, last_out = -1;  // at the end, as in FlowState
    std::vector<FlowSight> sights;                 // of t = 0, of each look, of the end
};

// That run as one of our own: looked at, ended and noted by the rig's rules. Throws std::runtime_error where by these it is not over.
FlowRun run_as_seen(const FlowSetup&, const SeenFlow&);

// Steps from t = 0 on to a look, the nearest one; far away where there is none of that number.
std::int64_t steps_to_look(const FlowSetup&, std::size_t number);

// Steps that a run is expected to take, for progress: an order of magnitude.
std::int64_t expected_steps(const FlowSetup&);

struct FlowQuantity {
    std::string name;
    double value;
    std::string unit;  // SI
};

struct FlowRecord {
    std::string
        ending;  // discharge: drained, jammed, recorded; column: at_rest, recorded; drum: recorded;
                 // all: not_at_rest, of the bed before t = 0 or of the column after
    std::vector<cases::Column> channels;  // of the rig
    std::vector<cases::Column> profile;   // of a drum: depth, velocity; else none
    std::vector<FlowQuantity> quantities;
    Heap grains;  // that are left, base_radius 0
    std::int64_t steps;
    std::uint64_t hash;  // of the final state in the setup's own units
};

FlowRecord record(const FlowRun&, const FlowSetup&);

}  // namespace rigs
