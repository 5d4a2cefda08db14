// SPDX-License-Identifier: MIT
#include "prove/path.hpp"

#include <algorithm>

namespace prove {

Quintic quintic(double t, double t0, double y0, double v0, double a0, double t1, double y1,
                double v1, double a1) {
    const double h = t1 - t0, s = (t - t0) / h;
    const double d = y1 - y0 - h * v0 - 0.5 * h * h * a0;
    const double e = h * (v1 - v0) - h * h * a0;
    const double f = h * h * (a1 - a0);
    const double c3 = 10.0 * d - 4.0 * e + 0.5 * f;
    const double c4 = -15.0 * d + 7.0 * e - f;
    const double c5 = 6.0 * d - 3.0 * e + 0.5 * f;
    const double value = y0 + s * (h * v0 + s * (0.5 * h * h * a0 + s * (c3 + s * (c4 + s * c5))));
    const double slope =
        (h * v0 + s * (h * h * a0 + s * (3.0 * c3 + s * (4.0 * c4 + s * 5.0 * c5)))) / h;
    return {value, slope};
}

Point Path::at(double t) const {
    if (t <= points_.front().t) return points_.front();
    if (t >= points_.back().t) return points_.back();
    if (last_ + 1 >= points_.size() || points_[last_].t > t) last_ = 0;
    while (points_[last_ + 1].t < t) ++last_;
    const Point &a = points_[last_], &b = points_[last_ + 1];
    const Quintic z = quintic(t, a.t, a.z, a.vz, a.az, b.t, b.z, b.vz, b.az);
    const Quintic x = quintic(t, a.t, a.x, a.vx, a.ax, b.t, b.x, b.vx, b.ax);
    const double h = b.t - a.t, s = (t - a.t) / h;
    const double d = b.spin - a.spin;
    // Cubic, from the spin and its rate at both ends.
    const double spin =
        a.spin + s * (h * a.spin_rate + s * (3.0 * d - h * (2.0 * a.spin_rate + b.spin_rate) +
                                             s * (h * (a.spin_rate + b.spin_rate) - 2.0 * d)));
    return {t, z.value, z.slope, 0.0, x.value, x.slope, 0.0, spin, 0.0};
}

}  // namespace prove
