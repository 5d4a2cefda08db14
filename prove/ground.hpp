// SPDX-License-Identifier: MIT
// A grain on a plane: it slides, rolls, or lies still. In each of the three the accelerations are smooth; where the slip, the
// velocity or the spin passes zero the next one is chosen. Constant accelerations are solved by quadratics, others by GSL.
#pragma once

#include "prove/path.hpp"
#include "prove/world.hpp"

namespace prove {

struct Load {
    double along;  // pull along the plane, m/s^2, positive downhill
    double hold;   // what friction and rolling resistance multiply, per mass: (N + 2 F_po)/m, m/s^2
};

// Goes on from path.back() (x, vx, spin) to t_end.
void move_on_ground(const World&, const Setup&, const Load&, double t_end, Path& path);

// Contact force and JKR's addition to it, from what presses the grain: m g cos(angle) + attraction in contact.
Load load_on_plane(const World&, const Setup&, double angle, bool wet);

}  // namespace prove
