// SPDX-License-Identifier: MIT
// What each vessel of rigs/flow.hpp does at its turn: one file each, discharge.cpp, column.cpp and drum.cpp. Called by flow.cpp.
#pragma once

#include "rigs/flow.hpp"

#include <vector>

namespace rigs {

// From conditions, in m and s. Throw scaling::InvalidInput.
Silo silo_of(const cases::Experiment&);
Column column_of(const cases::Experiment&);
Drum drum_of(const cases::Experiment&);
Filling filling_of(const Silo&, const cases::Experiment&);
Filling filling_of(const Column&, const cases::Experiment&);
Filling filling_of(const Drum&, const cases::Experiment&);

contact::Vec3 up(const Silo&);
contact::Vec3 up(const Column&);
contact::Vec3 up(const Drum&);

// The corners of the space where grains may begin; `high` is infinite upwards where the vessel is open.
dem_min::Box room(const Silo&);
dem_min::Box room(const Column&);
dem_min::Box room(const Drum&);
// Whether a grain there is clear of the side walls.
bool clear_of_walls(const Silo&, contact::Vec3, double radius);
bool clear_of_walls(const Column&, contact::Vec3, double radius);
bool clear_of_walls(const Drum&, contact::Vec3, double radius);

// Closed, as high as `top`, m.
std::vector<dem_min::Wall> walls_of(const Silo&, double top);
std::vector<dem_min::Wall> walls_of(const Column&, double top);
std::vector<dem_min::Wall> walls_of(const Drum&, double top);

// s, between two looks.
double usual_interval(const Silo&, const FlowSetup&);
double usual_interval(const Column&, const FlowSetup&);
double usual_interval(const Drum&, const FlowSetup&);
// s, after t = 0, for progress.
double expected_duration(const Silo&, const FlowSetup&);
double expected_duration(const Column&, const FlowSetup&);
double expected_duration(const Drum&, const FlowSetup&);

// s, after t = 0, of a run without a recording.
double run_time(const Drum&);

// At t = 0: opens, lifts, turns.
void let_go(const Silo&, dem_min::Simulation&);
void let_go(const Column&, dem_min::Simulation&);
void let_go(const Drum&, dem_min::Simulation&);

// At look number `look`, which is at `t` since t = 0: adds rows.
void look(const Silo&, FlowRun&, const FlowSetup&, double t, std::size_t number);
void look(const Column&, FlowRun&, const FlowSetup&, double t, std::size_t number);
void look(const Drum&, FlowRun&, const FlowSetup&, double t, std::size_t number);

// Every hundred steps after t = 0: whether it is over, by which ending; empty: it is not.
std::string watch(const Silo&, FlowRun&, const FlowSetup&);
std::string watch(const Column&, FlowRun&, const FlowSetup&);
std::string watch(const Drum&, FlowRun&, const FlowSetup&);

// Adds channels, profile and the vessel's own quantities.
void complete(const Silo&, FlowRecord&, const FlowRun&, const FlowSetup&);
void complete(const Column&, FlowRecord&, const FlowRun&, const FlowSetup&);
void complete(const Drum&, FlowRecord&, const FlowRun&, const FlowSetup&);

// Of flow.cpp. Whether the grains have been at rest, without a break, for the rest duration.
bool at_rest(FlowRun&, const FlowSetup&);
double mass_of(const dem_min::Simulation&);  // kg
double seconds_since_release(const FlowRun&, const FlowSetup&);

}  // namespace rigs
