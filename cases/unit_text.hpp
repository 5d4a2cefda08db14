// SPDX-License-Identifier: MIT
// The way that people write units, brought to one: plain ASCII with *, /, ^ and ( ).
#pragma once

#include "cases/units.hpp"

#include <stdexcept>
#include <string>

namespace cases {

// "J·m⁻²" -> "J*m^-2", "µm" (both code points) -> "um", "m**2" -> "m^2", "°" -> "deg", no-break
// spaces -> spaces.
std::string normalise(const std::string& text);

// Why a unit cannot be read; `symbol` is the part at fault.
struct UnitProblem : std::runtime_error {
    UnitProblem(std::string faulty_symbol, const std::string& rule)
        : std::runtime_error(rule), symbol(std::move(faulty_symbol)) {}
    std::string symbol;
};

// Takes a normalised unit apart: factors joined by *, ., /, "per" or a space, read from the left
// (J/m*s is (J/m)*s), each with a whole or rational power: m2, m^2, m-2, s^(1/5), s^0.2. Throws
// UnitProblem.
Unit parse_normalised_unit(const std::string& text);

}  // namespace cases
