// SPDX-License-Identifier: MIT
// The laws of docs/effects.md that act on a single grain beside its contact law: drag, buoyancy, attraction across a gap,
// restitution and friction that depend on speed, a plate that vibrates. Raw doubles are SI; each law is off as constructed.
#pragma once

#include "rigs/forward.hpp"

namespace rigs {

// Schiller & Naumann's curve, which ends at Re = 1000: Cd = 24/Re (1 + 0.15 Re^0.687) below, 0.44 above (Newton).
double drag_coefficient_at(double reynolds);

struct Drag {
    double factor = 0.0;                    // k; 0: no drag
    double density = 0.0, viscosity = 0.0;  // kg/m^3, Pa s, of the fluid
    double diameter = 0.0;                  // m

    double reynolds(double speed) const;  // infinite in a fluid without viscosity
    bool beyond(double speed) const { return reynolds(speed) >= 1000.0; }
    // Force over speed, kg/s; `newton`: by the branch above Re = 1000, whatever Re is. The caller changes branches where it
    // crosses Re = 1000, so that no step runs over the edge.
    double resistance(double speed, bool newton) const;
};

// Pull towards the counterpart across a gap.
struct Attraction {
    double hamaker_r = 0.0;        // A R*, J m
    double bridge = 0.0;           // N, 4 pi gamma R* cos(theta) of the closed bridge
    double bridge_area = 0.0;      // m^2, V/(pi R*)
    double rupture = 0.0;          // m, (1 + theta/2) V^(1/3)
    double charge_term = 0.0;      // N m^2: q^2/(16 pi eps0), or -q^2/(4 pi eps0) between grains
    double charge_distance = 1.0;  // m, R or 2 R

    bool none() const { return hamaker_r == 0.0 && bridge == 0.0 && charge_term == 0.0; }
    double across(double gap, bool bridged) const;  // N, > 0 towards it; gap >= 0
    // N/m: by how much the pull falls with the gap; >= 0 but for charges that repel.
    double steepness(double gap, bool bridged) const;
    double in_contact() const;  // N: closed bridge and charge, no van der Waals
};

struct Friction {
    double at_rest = 0.0;   // sliding_friction
    double dynamic = 0.0;   // where fast
    double velocity = 0.0;  // m/s; 0: the same at every speed
    bool depends() const { return velocity > 0.0 && dynamic != at_rest; }
    double at(double slip) const;  // 1; slip >= 0
};

struct Restitution {
    double slow = 1.0;              // `restitution`
    double loss = -1.0;             // (s/m)^(1/5); < 0: not viscoelastic
    double yield_velocity = 0.0;    // m/s; 0: not plastic
    double at(double speed) const;  // 1, 0 to 1; speed > 0, normal
};

struct Vibration {
    double amplitude = 0.0, omega = 0.0, phase = 0.0;  // m, rad/s, rad
    struct Motion {
        double height, velocity;  // m, m/s
    };
    Motion at(double t) const;
    double height(double t) const { return at(t).height; }
    double velocity(double t) const { return at(t).velocity; }
    double acceleration(double t) const;
};

// Straight between the knots, constant beyond them; 0 where there are none.
double straight_between(const std::vector<double>& knots, const std::vector<double>& values,
                        double at);

}  // namespace rigs
