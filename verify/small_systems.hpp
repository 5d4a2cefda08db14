// SPDX-License-Identifier: MIT
// The systems of the exact answers: two grains, or one grain and a plane, on dem_min.
#pragma once

#include "dem_min/simulation.hpp"

namespace verify {

// Glass-like, softened: a sphere of 1 mm radius under its own weight is flattened by 3e-5 of it.
struct Sphere {
    double radius = 1e-3;     // m
    double density = 2500.0;  // kg/m^3
    double e_star = 1e8;      // Pa
    double g_star = 2e7;      // Pa
    double mass() const;      // kg
};

struct ContactChoice {
    double work_of_adhesion = 0.0;  // J/m^2; 0: Hertz
    double restitution = 1.0;
    double sliding_friction = 0.0;
    double rolling_friction = 0.0;
    bool rigid_tangential = false;  // Coulomb instead of Mindlin
};
dem_min::Laws laws(const Sphere&, const ContactChoice&);

// Grains 0 and 1 on the x axis, `gap` apart, closing at `speed`. No gravity.
dem_min::Simulation two_grains(const Sphere&, const ContactChoice&, double speed, double gap,
                               double time_step);

// Grain 0 over the plane z = 0, its lowest point at `height`.
dem_min::Simulation grain_on_plane(const Sphere&, const ContactChoice&, double height,
                                   dem_min::Vec3 velocity, dem_min::Vec3 gravity, double time_step);

// How deep a Hertzian sphere sinks into a plane under a force: (3 F/(4 E* sqrt R))^(2/3), m.
double resting_overlap(const Sphere&, double force);

}  // namespace verify
