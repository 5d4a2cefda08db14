// SPDX-License-Identifier: MIT
// A run as a hasty user would make it: fixed steps too long for the contact, Euler's method, a modulus made soft. The law is
// the right one, so that refinement removes the mismatch.
//   verlet   v += a dt/2, x += v dt, v += a(x) dt/2        euler   x += v dt, v += a dt, both from the old state
// `softening` multiplies E* and G* of the contact.
#pragma once

#include "prove/figures.hpp"

#include <optional>
#include <string>

namespace prove {

// What the user's program would have recorded; shape of predict(World, Setup). UserRun stands in the setup.
std::vector<double> user_run(const World&, const Setup&);

// Whose steps or modulus leave IDR near the target; nothing where none does.
std::optional<UserRun> draw_user_run(Skeleton&, double target, Dice&);
UserRun harmless_run(const Skeleton&);
Mismatch user_mismatch(const Skeleton&, const UserRun&);
// The run of the user's model with its start values, all experiments.
Eigen::VectorXd start_run(const Skeleton&, const UserRun&);

std::string numerics_text(const UserRun&);  // JSON
// Of an undamped Hertzian impact at this speed, s.
double hertz_duration(const Setup&, double speed);

}  // namespace prove
