// SPDX-License-Identifier: MIT
#include <cmath>
double length_scale(double w, double r_star, double e_star) {
    return std::cbrt(w * r_star * r_star / e_star);
}
