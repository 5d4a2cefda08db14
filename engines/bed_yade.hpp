// SPDX-License-Identifier: MIT
// The bed in Yade's language, as near as it comes: Hertz and Mindlin with DMT adhesion (its surface
// energy gamma pulls with 4 pi gamma R*), no rolling resistance, and walls at the sides, because
// its periodic cell is periodic in z too. Written by its manual (Law2_ScGeom_MindlinPhys_Mindlin,
// InsertionSortCollider); never run: the package was not at hand.
#pragma once

#include "engines/bed_engine.hpp"

namespace engines {

BedEngine yade();

}  // namespace engines
