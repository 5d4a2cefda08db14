// SPDX-License-Identifier: MIT
// What the numbers of other engines mean: adhesion, rolling friction, damping. One table each; a pull-off force, a torque or a
// restitution is what two engines can have in common (docs/convert.md).
#pragma once

#include <string>
#include <vector>

namespace engines {

// Two grains in contact, or a grain at a wall.
struct Pair {
    double r_star;  // m: R/2 of equal grains, R at a wall
    double e_star;  // Pa
    double radius;  // m, of the grain
    double weight;  // N, of the grain
    bool wall;
};

// What pulls once it is known how hard.
enum class Pull {
    jkr,      // of the area in contact, with a neck beyond touch
    dmt,      // constant, added to Hertz' force
    per_area  // an energy density times the area of overlap: no pull at touch
};

struct AdhesionConvention {
    std::string name;       // as --from and --to take it: "lammps_jkr"
    std::string engine;     // "LAMMPS, pair_style granular, jkr"
    std::string parameter;  // as the engine calls it
    std::string unit;       // SI
    Pull pull;
    double
        factor;  // jkr, dmt: pull-off force = factor pi R* value; per_area: area = factor pi R* overlap
    std::string differs;  // from JKR as it is, in a sentence; may be empty
    std::string source;
    double at_wall = 1.0;  // per_area: the area at a wall over that between grains of one R*

    // N, the largest tension, for a value in SI units; and back. Both > 0.
    double pull_off(double value, const Pair&) const;
    double value(double pull_off, const Pair&) const;
    // J/m^2, w of the JKR or DMT law with that pull-off, and back; NaN for per_area, which has none.
    double work_of_adhesion(double pull_off, const Pair&) const;
    double pull_off_of_work(double work_of_adhesion, const Pair&) const;
};

const std::vector<AdhesionConvention>& adhesion_conventions();

// Engines whose number cannot be turned into a force from what their makers publish; what to do instead.
struct Unpublished {
    std::string name, engine, instead;
};
const std::vector<Unpublished>& unpublished_adhesion();

struct RollingConvention {
    std::string name, engine, parameter;
    // Largest torque of a contact = value * lever * normal force; lever in R* or in the grain's own radius.
    double r_star, radius;
    std::string differs, source;

    double lever(const Pair&) const;  // m
};
const std::vector<RollingConvention>& rolling_conventions();

// Dashpots that are told by the restitution e of a Hertz contact without adhesion.
struct DampingConvention {
    std::string name, engine, parameter;
    double (*value)(double e);  // of the parameter
    std::string differs, source;
};
const std::vector<DampingConvention>& damping_conventions();

}  // namespace engines
