// SPDX-License-Identifier: MIT
#pragma once

namespace app {

// Grain steps per second of this machine, from about a third of a second of a block of 1728
// adhesive grains in contact with all laws on; the fastest of many short bursts. It moves by some
// 10 % from call to call.
double measured_speed(int threads);

}  // namespace app
