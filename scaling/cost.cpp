// SPDX-License-Identifier: MIT
#include "scaling/cost.hpp"

#include "scaling/errors.hpp"
#include "scaling/numbers.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace scaling {

namespace {

constexpr double pi = std::numbers::pi;

void check_between(const char* name, double value, double low, double high, const char* remedy) {
    if (value > low && value < high) return;
    throw InvalidParameter(mistake(name, fmt::format("{:.6g}", value),
                                   fmt::format("must lie between {:.4g} and {:.4g}", low, high),
                                   remedy));
}

}  // namespace

Time rayleigh_time(const Grain& grain) {
    const Pressure g = shear_modulus(grain.youngs_modulus, grain.poisson_ratio);
    const double wave = std::sqrt((grain.density / g).value());  // s/m
    return in_si<Time>(0.5 * pi * grain.diameter.value() * wave /
                       (0.1631 * grain.poisson_ratio + 0.8766));
}

Volume heap_volume(const Heap& heap) {
    check_between("heap.base_diameter", heap.base_diameter.value(), 0.0, INFINITY, "in metres");
    check_between("heap.angle", heap.angle, 0.0, 0.5 * pi, "in radians");
    const Length d = heap.base_diameter;
    return pi / 24.0 * std::tan(heap.angle) * d * d * d;
}

double grains_in(const Heap& heap, Length grain_diameter) {
    check_between("heap.packing_fraction", heap.packing_fraction, 0.0, 1.0,
                  "solid volume over bulk volume");
    check_between("grain.diameter", grain_diameter.value(), 0.0, INFINITY, "in metres");
    const Volume grain = pi / 6.0 * grain_diameter * grain_diameter * grain_diameter;
    return heap.packing_fraction * Dimensionless(heap_volume(heap) / grain).value();
}

Cost cost(const CostInput& in) {
    check(in.grain);
    check_between("rayleigh_fraction", in.rayleigh_fraction, 0.0, 1.0,
                  "0.2 is the habit of the field");
    if (in.grains)
        check_between("grains", *in.grains, 0.0, INFINITY, "the number that is simulated");
    if (in.duration) check_between("duration", in.duration->value(), 0.0, INFINITY, "in seconds");
    const Time rayleigh = rayleigh_time(in.grain);
    Cost made{in.grains, rayleigh, in.rayleigh_fraction * rayleigh, std::nullopt, std::nullopt};
    if (in.duration) made.steps = std::ceil(Dimensionless(*in.duration / made.time_step).value());
    if (made.steps && made.grains && in.grain_steps_per_second) {
        check_between("grain_steps_per_second", *in.grain_steps_per_second, 0.0, INFINITY,
                      "as measured");
        made.wall_time = in_si<Time>(*made.steps * *made.grains / *in.grain_steps_per_second);
    }
    return made;
}

double originals_per_grain(const ScaleMap& map) {
    return map.value(Rational(3) * (map.exponents("length") - map.exponents("apparatus_length")));
}

CostInput scaled(const CostInput& in, const ScaleMap& map) {
    CostInput made = in;
    made.grain = scaled(in.grain, map);
    if (made.grains) *made.grains /= originals_per_grain(map);
    if (made.duration) *made.duration *= map.factor("time");
    return made;
}

}  // namespace scaling
