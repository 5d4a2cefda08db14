// SPDX-License-Identifier: MIT
// What is fitted: the free parameters of the user's model, what is known only within an uncertainty, and the parameters of an
// effect that may have been left out.
#pragma once

#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <vector>

namespace diagnose {

enum class Prior {
    uniform,      // between low and high, hard ends
    log_uniform,  // likewise, in the logarithm: low > 0
    gaussian      // mean and deviation; low and high far out
};

// Where a value goes.
enum class Target {
    parameter,        // rigs::World::parameters[key]
    stated,           // rigs::World::stated[key], of one experiment or of all
    scale,            // recorded = value x true, of the channels in key ("z,x")
    offset,           // recorded = true + value, of the channel key
    time_factor,      // recorded time = value x true time
    base_line,        // recorded = true + value
    base_line_slope,  // recorded = true + value (ordinate - middle of the ordinates)
    missing_shape     // what is missing is the sum of value x Term::missing_shapes[index]
};

struct Unknown {
    std::string name, unit;  // as reported; SI
    Target target = Target::parameter;
    std::string key{};
    Prior prior = Prior::uniform;
    double low = 0.0, high = 1.0;  // SI
    double mean = 0.0, deviation = 0.0;
    std::string experiment{};  // empty: one value for all experiments
    std::size_t index = 0;     // of a shape
    double start = 0.0;
    bool turns = false;  // from low to high is a full turn: both ends are one place
};

// A parameter of the model, anywhere between the two alike in the logarithm; low > 0.
inline Unknown log_range(const std::string& name, const std::string& unit, double low,
                         double high) {
    return {.name = name,
            .unit = unit,
            .key = name,
            .prior = Prior::log_uniform,
            .low = low,
            .high = high,
            .start = std::sqrt(low * high)};
}

// What no effect of the catalogue gives, where none of these is the answer.
enum class Missing {
    force,        // N; rigs::World::missing
    restitution,  // share of the normal rebound; rigs::World::missing_restitution
    drift         // of a reading, in its unit, recorded = true + drift
};

// One effect that may have been left out.
struct Term {
    std::string effect;             // its name in a verdict
    std::string channel{};          // of a measurement effect
    std::vector<Unknown> unknowns;  // the first sets the strength
    std::vector<std::string>
        idle{};              // parameters of the base model that have no influence beside it
    bool two_sided = false;  // the first unknown may have either sign
    std::string missing_variable{};        // it is a function of; empty: nothing is missing
    std::set<std::string> missing_rigs{};  // those whose state has that variable; it acts there
    std::vector<double> missing_knots{};
    std::vector<std::vector<double>> missing_shapes{};  // [unknowns][knots]
    Missing missing = Missing::force;                   // a drift has its channel in `channel`
};

}  // namespace diagnose
