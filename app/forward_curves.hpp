// SPDX-License-Identifier: MIT
#pragma once

#include "cases/csv.hpp"
#include "rigs/forward.hpp"

#include <vector>

namespace app {

// What the rig's forward model says at these ordinates, as its channels: the ordinate first, `branch` last where
// there are two. Of a rig with a forward model.
std::vector<cases::Column> forward_curves(const cases::Experiment&, const rigs::World&,
                                          const rigs::Ordinates&);
// Channels that have been worked out, as such columns.
std::vector<cases::Column> curve_columns(const cases::Experiment&, const rigs::Curves&,
                                         const rigs::Ordinates&);

}  // namespace app
