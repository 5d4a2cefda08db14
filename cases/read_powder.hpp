// SPDX-License-Identifier: MIT
// The parts of a case that an experiment may override: grain, plate, surroundings.
#pragma once

#include "cases/case.hpp"

namespace cases {

// `object` with the members of `overriding` in place of its own. What contradicts an overriding key goes: another
// diameter drops the sizes, one modulus the other.
Value overridden(const Value& object, const Value& overriding);

// Each checks its keys, dimensions and ranges; throws scaling::InvalidInput.
Grain read_grain(const Value& grain, const MaterialNames& = {});
Plate read_plate(const Value& plate);
Surroundings read_surroundings(const Value& surroundings);

}  // namespace cases
