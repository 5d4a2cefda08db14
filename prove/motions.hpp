// SPDX-License-Identifier: MIT
// The true motion of each rig, without the instruments. Shape of all results: [recorded][ordinates], one channel behind the
// other.
#pragma once

#include "prove/world.hpp"

#include <vector>

namespace prove {

// Flights by quadratic (constant forces) or by GSL's Dormand-Prince 8; impacts by prove/collision.hpp; after the last bounce
// the grain slides and rolls (prove/ground.hpp).
std::vector<double> drop(const World&, const Setup&);
std::vector<double> incline(const World&, const Setup&);
std::vector<double> impact(const World&, const Setup&);
std::vector<double> pull_off(const World&, const Setup&);

}  // namespace prove
