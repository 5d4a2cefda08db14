// SPDX-License-Identifier: MIT
// A grain that stays on a plane: it slides, rolls or rests. s and v along the plane, w = R spin, so that v - w is the slip.
//   sliding:  v' = pull - mu P sgn(slip),  w' = 5/2 (mu P sgn(slip) - mu_r P sgn(w))
//   rolling:  v' = w' = 5/7 (pull - mu_r P sgn(v)),  as long as friction of at most mu P can hold it
//   rest:     |pull| <= mu_r P and <= mu P
// P what friction multiplies, over mass; pull what drives, over mass, drag taken off. Solid sphere, I = 2/5 m R^2. Closed form
// where the rates are constant. With the impulse of the normal force in place of time (P = 1, no pull) it is an impact under
// rigid friction.
#pragma once

#include "rigs/effects.hpp"

#include <functional>
#include <vector>

namespace rigs {

struct OnPlate {
    double t, s, v, w;    // s, m, m/s, m/s
    bool newton = false;  // the branch of the drag curve
};

struct PlateForces {
    double along = 0.0;                               // m/s^2, drives towards +s
    double press = 0.0;                               // m/s^2, P; 0 or less: nothing holds it
    Friction friction{};                              // mu
    double rolling_friction = 0.0;                    // mu_r
    const Drag* drag = nullptr;                       // none where null or its factor is 0
    double mass = 1.0;                                // kg, for drag and the force below
    std::function<double(const OnPlate&)> further{};  // N towards +s; may be empty
};

// The times, rising, at which the state is wanted. One set of rows serves a whole run.
struct Rows {
    const std::vector<double>& at;
    std::size_t next = 0;
    bool done() const { return next == at.size(); }
    double time() const;  // of the next row; infinite where there is none
};

// Carries the state to `until`, or only as far as the last row lies, telling `record` each row passed on the way.
void carry(OnPlate& state, double until, const PlateForces& forces, Rows& rows,
           const std::function<void(std::size_t, const OnPlate&)>& record);

// The same without rows, over `duration`: time, or impulse over mass.
void carry(OnPlate& state, double duration, const PlateForces& forces);

}  // namespace rigs
