// SPDX-License-Identifier: MIT
#include <cmath>
double force(double r_star, double overlap) { return std::sqrt(r_star) * std::pow(overlap, 1.5); }
