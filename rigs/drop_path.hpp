// SPDX-License-Identifier: MIT
// The way of one grain above one plate: flight, contact, flight, ..., rest. Flight is a parabola in closed form where nothing
// depends on speed or gap, else integrated; contacts are rigs/one_contact.hpp, rest is rigs/on_plate.hpp.
#pragma once

#include "rigs/one_grain.hpp"

#include <cmath>
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

struct DropState {
    double t, x, z;    // s, m, m; z of the lowest point
    double vx, vz, w;  // m/s; w = R spin
    double impact_speed =
        0.0;  // m/s, normal, relative to the plate, of the last impact; 0 before the first
    bool bridged = false;  // a liquid bridge holds
    double speed() const { return std::sqrt(vx * vx + vz * vz); }
};

struct DropPath {
    std::vector<DropState> states;  // [times]
    bool settled = false;           // lies still, slides or rolls: does not leave the plate again
    double settled_at = 0.0;        // s
    int impacts = 0;
    std::int64_t steps = 0;  // fixed ones, where the numerics ask for them
};

// What acts on the grain in the air, and how its run was made. `missing` and `numerics` may be null.
struct DropWorld {
    const OneGrain* grain;
    const MissingForce* missing;
    const cases::Numerics* numerics;
    double into, along;  // m/s^2, of gravity: into the plate, and along x

    DropWorld(const OneGrain&, const MissingForce*, const cases::Numerics*);
    bool ballistic() const;
    // N upward beside weight and drag, at a gap >= 0.
    double lift(const DropState&, double gap) const;
    // m/s^2 into the plate of a grain at rest there.
    double holding() const;
    // The same where it has barely left: van der Waals' pull and the missing force are in it.
    double grip(const DropState&) const;
};

// `times` must not fall.
DropPath follow_drop(const DropWorld&, const DropConditions&, const std::vector<double>& times);

}  // namespace rigs
