// SPDX-License-Identifier: MIT
// A motion as points with velocity and acceleration, and the polynomial of degree five between two of them: exact for
// constant acceleration, sixth order for others.
#pragma once

#include <cstddef>
#include <vector>

namespace prove {

struct Point {
    double t;
    double z, vz, az;
    double x, vx, ax;
    double spin, spin_rate;
};

// Value and slope at t of the quintic through (y, v, a) at both ends.
struct Quintic {
    double value, slope;
};
Quintic quintic(double t, double t0, double y0, double v0, double a0, double t1, double y1,
                double v1, double a1);

class Path {
  public:
    void add(const Point& p) { points_.push_back(p); }
    const Point& back() const { return points_.back(); }
    bool empty() const { return points_.empty(); }
    // Rows must be asked for in rising order, or from the start again: the search begins at the last interval.
    Point at(double t) const;

  private:
    std::vector<Point> points_;
    mutable std::size_t last_ = 0;
};

}  // namespace prove
