// SPDX-License-Identifier: MIT
#include <limits>
bool converged(double step) { return step < std::numeric_limits<double>::epsilon(); }
