// SPDX-License-Identifier: MIT
// The effects that may have been left out of a rig of many grains: their unknowns, and the coordinates in which an emulator sees
// them. One more effect is one more line of the table, once the core has its law.
#pragma once

#include "cases/case.hpp"
#include "diagnose/unknowns.hpp"
#include "rigs/forward.hpp"

#include <optional>
#include <string>
#include <vector>

namespace diagnose {

// One coordinate of an emulator: a parameter of the world, of the user's model or of an effect that may be there.
struct Axis {
    // effect empty: of the user's model. parameter empty: an effect without one, there or not.
    std::string parameter, effect;
    double low, high;  // SI: the values that are run
    // Of an effect the coordinate is log(1 + value/knee): in proportion below the knee, in decades above.
    double knee = 0.0;
    std::string beside{};  // that of another parameter: log((knee + value)/(knee + the other's))
};

// -1 to 1 over what is run, flat beyond; where the effect is not there -1, or 0 of one that has its value beside another's.
double coordinate(const Axis&, const rigs::World&);
// The value at this coordinate, of an effect that stands alone; `other`: that of the parameter beside it.
double value_at(const Axis&, double x, double other = 0.0);

struct BulkEffect {
    std::string effect;
    std::vector<Unknown> unknowns;  // the first sets the strength
    bool two_sided = false;
    std::vector<Axis> axes{};
};

// Those that the core has a law for, that can act in this pile and that are not in the model. Ranges: docs/diagnose-piles.md.
std::vector<BulkEffect> bulk_effects(const cases::Case&, const cases::Experiment&);

// The free parameters of the model that act in this pile.
std::vector<Axis> free_axes(const cases::Case&, const cases::Experiment&);

// The case as the world has it, for one of its experiments.
cases::Case in_world(const cases::Case&, const rigs::World&);

}  // namespace diagnose
