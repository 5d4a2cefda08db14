// SPDX-License-Identifier: MIT
// The rig `drop`: one grain released above a flat horizontal plate (docs/drop.md). Contacts run on dem_min; in the air the
// grain is carried along its parabola in one go, so that a drop of seconds costs milliseconds.
#pragma once

#include "cases/case.hpp"
#include "rigs/physics.hpp"

#include <cstdint>
#include <vector>

namespace rigs {

struct DropConditions {
    double height;            // m, of the lowest point
    double speed;             // m/s, downward
    double horizontal_speed;  // m/s, along x
    double spin;              // rad/s, > 0 where it would roll along +x
    double release_time;      // s: until then the grain is held
};

// From an experiment of the rig `drop`; all but the height 0 where left out. Throws scaling::InvalidInput.
DropConditions drop_conditions(const cases::Experiment&);

struct DropSetup {
    DropConditions conditions;
    double radius, density;  // m, kg/m^3
    double gravity;          // m/s^2, along -z; 0 where the model has none
    ContactParameters plate;
    double steps_per_impact = 400.0;  // of a Hertz impact at the speed of each touch
};

// `restitution`, `work_of_adhesion` and the frictions of the model hold at the plate. Throws scaling::InvalidInput where the
// model holds physics other than gravity, hertz_mindlin, hertz_coulomb, adhesion and rolling_resistance.
DropSetup drop_setup(const cases::Case&, const cases::Experiment&);

struct DropRecord {
    std::vector<double> t, z, x;  // s, m, m; z of the lowest point, x from the place of release
    bool settled = false;         // lies still, or rolls steadily
    double settled_at = 0.0;      // s
    int impacts = 0;
    std::int64_t steps = 0;  // of dem_min
};

// At the given times, which must not fall. Throws scaling::InvalidParameter otherwise.
DropRecord run_drop(const DropSetup&, const std::vector<double>& times);

// At `count` even times from 0 until the grain has settled, or 20 times the first fall where it does not within them. Throws
// scaling::InvalidParameter where it never comes down.
DropRecord run_drop(const DropSetup&, int count = 200);

}  // namespace rigs
