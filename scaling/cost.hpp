// SPDX-License-Identifier: MIT
// What a simulation costs before and after scaling: grains, time step, steps, wall time.
#pragma once

#include "scaling/adhesion.hpp"

#include <optional>

namespace scaling {

// Time of a Rayleigh wave around a grain, pi R sqrt(rho / G) / (0.1631 nu + 0.8766); Ning & Ghadiri
// (2006), Chem. Eng. Sci. 61, 5991. An explicit step is a fraction of it, often 0.2.
Time rayleigh_time(const Grain&);

// A heap that covers its base: a cone of angle alpha on a disc, pi D^3 tan(alpha) / 24.
struct Heap {
    Length base_diameter;     // > 0
    double angle;             // rad, in (0, pi/2)
    double packing_fraction;  // in (0, 1)
};

// Throws InvalidParameter naming the member that is out of range.
Volume heap_volume(const Heap&);  // bulk, air included
double grains_in(const Heap&, Length grain_diameter);

// All of the original problem.
struct CostInput {
    Grain grain;
    std::optional<double> grains;                  // > 0
    std::optional<Time> duration;                  // simulated, > 0
    double rayleigh_fraction;                      // time step over Rayleigh time, in (0, 1)
    std::optional<double> grain_steps_per_second;  // measured speed of the machine, > 0
};

struct Cost {
    std::optional<double> grains;
    Time rayleigh_time, time_step;
    std::optional<double> steps;
    std::optional<Time> wall_time;
};

Cost cost(const CostInput&);

// The same problem after scaling: durations follow the surroundings' clock, grains fill an
// apparatus that may be kept.
CostInput scaled(const CostInput&, const ScaleMap&);

// Grains that one scaled grain stands for: 1 where the apparatus grows along, h^3 where it is kept.
double originals_per_grain(const ScaleMap&);

}  // namespace scaling
