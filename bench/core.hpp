// SPDX-License-Identifier: MIT
// Where the core is younger than this room: used where it is there.
#pragma once

#include "dem_min/simulation.hpp"

#include <cstddef>
#include <optional>

namespace bench {

// B, of a whole simulation.
struct Memory {
    double grains = 0.0, contacts = 0.0, lists = 0.0;
    double total() const { return grains + contacts + lists; }
};

template <class Settings>
void set_periods(Settings& settings, double x, double y) {
    if constexpr (requires { settings.period_x; }) {
        settings.period_x = x;
        settings.period_y = y;
    }
}

template <class Settings>
constexpr bool has_periods(const Settings&) {
    return requires(Settings s) { s.period_x; };
}

template <class Simulation>
void take_steps(Simulation& s, int steps) {
    if constexpr (requires { advance(s, steps); })
        advance(s, steps);
    else
        for (int k = 0; k < steps; ++k) step(s);
}

template <class Simulation>
std::optional<Memory> memory_of(const Simulation& s) {
    if constexpr (requires { memory_use(s); }) {
        const auto use = memory_use(s);
        return Memory{static_cast<double>(use.bytes_grains),
                      static_cast<double>(use.bytes_contacts),
                      static_cast<double>(use.bytes_lists)};
    }
    return std::nullopt;
}

}  // namespace bench
