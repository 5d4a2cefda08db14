// SPDX-License-Identifier: MIT
// A drop as a user's run at a fixed time step made it, right or wrong: every step of the contact lies on the grid of that run.
//   verlet  v += a dt/2, z += v dt, a(z, v), v += a dt/2
//   euler   z += v dt, v += a(z before, v before) dt            (explicit)
// In the air, where nothing depends on speed or gap, the steps are summed in closed form: under a constant force verlet meets
// the parabola at every step, and euler another one, which starts faster by g dt/2.
#pragma once

#include "rigs/flight.hpp"

namespace rigs {

void step_drop(const DropWorld&, DropState&, DropRows&);

}  // namespace rigs
