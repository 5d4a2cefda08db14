// SPDX-License-Identifier: MIT
// The bed in LIGGGHTS' language, as near as it comes: it has no JKR, no SDS rolling and its wall is
// a material of its own. LIGGGHTS manual: gran model hertz, tangential history, cohesion sjkr,
// rolling_friction cdt.
#pragma once

#include "engines/bed_engine.hpp"

namespace engines {

BedEngine liggghts();

}  // namespace engines
