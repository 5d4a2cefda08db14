// SPDX-License-Identifier: MIT
#include "verify/small_systems.hpp"

#include <cmath>
#include <numbers>

namespace verify {

double Sphere::mass() const {
    return density * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
}

dem_min::Laws laws(const Sphere& sphere, const ContactChoice& choice) {
    dem_min::Laws result{contact::Hertz{sphere.e_star},
                         contact::Mindlin{sphere.g_star, choice.sliding_friction},
                         contact::NoRolling{}, contact::DampingTsuji1992::from(choice.restitution)};
    if (choice.work_of_adhesion > 0.0)
        result.normal = contact::Jkr{sphere.e_star, choice.work_of_adhesion};
    if (choice.rigid_tangential) result.tangential = contact::Coulomb{choice.sliding_friction};
    if (choice.rolling_friction > 0.0)
        result.rolling = contact::RollingEpsd{choice.rolling_friction, 0.3};
    return result;
}

dem_min::Simulation two_grains(const Sphere& sphere, const ContactChoice& choice, double speed,
                               double gap, double time_step) {
    dem_min::Simulation s;
    s.settings = {
        .time_step = time_step, .skin = 0.1 * sphere.radius, .gravity = {}, .lost_below = -1.0};
    s.between_grains = s.at_walls = laws(sphere, choice);
    const double x = sphere.radius + 0.5 * gap, v = 0.5 * speed;
    dem_min::insert(s, {{-x, 0.0, 0.0}, {v, 0.0, 0.0}, {}, sphere.radius, sphere.density});
    dem_min::insert(s, {{x, 0.0, 0.0}, {-v, 0.0, 0.0}, {}, sphere.radius, sphere.density});
    return s;
}

dem_min::Simulation grain_on_plane(const Sphere& sphere, const ContactChoice& choice, double height,
                                   dem_min::Vec3 velocity, dem_min::Vec3 gravity,
                                   double time_step) {
    dem_min::Simulation s;
    s.settings = {.time_step = time_step,
                  .skin = 0.1 * sphere.radius,
                  .gravity = gravity,
                  .lost_below = -1e3};
    s.between_grains = s.at_walls = laws(sphere, choice);
    s.walls = {dem_min::Plane{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}};
    dem_min::insert(
        s, {{0.0, 0.0, sphere.radius + height}, velocity, {}, sphere.radius, sphere.density});
    return s;
}

double resting_overlap(const Sphere& sphere, double force) {
    return std::pow(3.0 * force / (4.0 * sphere.e_star * std::sqrt(sphere.radius)), 2.0 / 3.0);
}

}  // namespace verify
