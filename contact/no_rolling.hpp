// SPDX-License-Identifier: MIT
// No rolling resistance: a point contact transmits no torque of its own.
#pragma once

#include "contact/concepts.hpp"

namespace contact {

struct NoRolling {
    RollingState step(const RollingInput&) const { return {{}, {}, {}, 0.0, 0.0}; }
};

}  // namespace contact
