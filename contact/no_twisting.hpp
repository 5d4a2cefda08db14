// SPDX-License-Identifier: MIT
// No twisting resistance: a point contact may be screwed freely.
#pragma once

#include "contact/twisting_marshall2009.hpp"

namespace contact {

struct NoTwisting {
    TwistingState step(const TwistingInput&) const { return {0.0, 0.0, 0.0, 0.0}; }
};

}  // namespace contact
