// SPDX-License-Identifier: MIT
// One impact of a grain with the plate.
//   normal      by definition: away at e times the speed. Hertz with a dashpot of this e gives the course in between, in one
//               dimensionless form for all speeds: x'' = -x^1.5 - f sqrt(1.5) x^0.25 x', f = sqrt(10/3) beta(e) (Tsuji, Tanaka &
//               Ishida 1992). With adhesion the equation is integrated with JKR's force (GSL), and the grain may stick.
//   tangential  rigid Coulomb: closed form of Walton (1993) in the impulse; or micro-slip: a spring 8 G* a with slider and
//               dashpot, (7/2)/m of its force on the slip.
// Unit of time L/v, of length L = (m v^2/K)^(2/5), K = 4/3 E* sqrt(R).
#pragma once

#include "prove/world.hpp"

#include <vector>

namespace prove {

struct ContactNode {
    double t, overlap, rate;  // rate of the overlap
    double radius;            // of the contact
    double cap;               // what friction multiplies, N
};

struct NormalContact {
    std::vector<ContactNode> nodes;
    double duration = 0.0;
    double rebound = 0.0;  // m/s, away from the plate
    bool stuck = false;
    double damping_factor = 0.0;  // f
};

struct Slip {
    double velocity, spin;  // of the centre along the plate, of the grain
};

double damping_factor(double restitution);
// e at this normal speed; `angle` from the normal.
double restitution_at(const World&, double normal_speed, double angle);
double friction_at(const World&, double slip);

// The dimensionless course for one e: nodes with unit K, m, v; the last one at overlap 0.
std::vector<ContactNode> hertz_course(double restitution);

// With JKR adhesion: born at touch, ends at the fold; the grain may stick.
NormalContact adhesive_contact(const World&, const Setup&, double normal_speed, double restitution);
// Without, from a course made before.
NormalContact scaled_course(const Setup&, const std::vector<ContactNode>& course,
                            double normal_speed, double restitution);

// What friction makes of velocity and spin in the course of this contact.
Slip after_contact(const World&, const Setup&, const NormalContact&, Slip before);

// JKR, parametric in the contact radius (Johnson, Kendall & Roberts 1971), stable branch. F > 0 repulsive.
struct Jkr {
    double e_star, r_star, w;
    double fold() const;  // overlap at which the contact ends, < 0
    double radius(double overlap) const;
    double force(double contact_radius) const;
    double pull_off_force() const;
};

}  // namespace prove
