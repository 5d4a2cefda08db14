// SPDX-License-Identifier: MIT
// Free flight, and a sphere on an incline that resists rolling.
#include "verify/exact_answers.hpp"
#include "verify/small_systems.hpp"

#include <cmath>
#include <numbers>

namespace verify {
namespace {

constexpr const char* group = "flight_and_rolling";
constexpr double g = 9.81;
const Sphere sphere;

void free_flight(std::vector<Check>& checks) {
    const double time_step = 1e-4, height = 10.0;
    dem_min::Simulation s =
        grain_on_plane(sphere, {}, height, {0.4, 0.0, 1.0}, {0.0, 0.0, -g}, time_step);
    s.grains.wx[0] = 3.0, s.grains.wy[0] = -5.0, s.grains.wz[0] = 7.0;
    for (int k = 0; k < 10000; ++k) dem_min::step(s);
    const char* reason = "Verlet is exact in a constant field; 1e4 roundings";
    const char* source = "Galilei: z = z0 + v t - g t^2/2";
    checks.push_back(
        check_relative({"height after a second of free flight", group, "m", reason, source},
                       height + sphere.radius + 1.0 - 0.5 * g, s.grains.z[0], 1e-11));
    checks.push_back(
        check_relative({"way along after a second of free flight", group, "m", reason, source}, 0.4,
                       s.grains.x[0], 1e-11));
    checks.push_back(check_relative({"speed of fall after a second", group, "m/s", reason, source},
                                    1.0 - g, s.grains.vz[0], 1e-11));
    checks.push_back(
        check_absolute({"spin changes in free flight by nothing", group, "rad/s",
                        "no torque acts: no bit may change", "conservation of angular momentum"},
                       0.0, contact::norm(s.grains.spin(0) - dem_min::Vec3{3.0, -5.0, 7.0}), 0.0));
}

// On a plane tilted by theta the weight's moment about the contact is m g R sin(theta), the resistance at most
// mu_r R m g cos(theta): it rolls for tan(theta) > mu_r, and then with (5/7) g (sin(theta) - mu_r cos(theta)).
void incline(std::vector<Check>& checks) {
    const double mu_r = 0.1, time_step = 1e-6;
    const ContactChoice choice{
        .restitution = 0.3, .sliding_friction = 0.8, .rolling_friction = mu_r};
    const char* source = "torque balance about the contact; rolling inertia 7/5 m R^2";
    for (const double share : {0.8, 1.5, 3.0}) {
        const double angle = std::atan(share * mu_r);
        const dem_min::Vec3 gravity{g * std::sin(angle), 0.0, -g * std::cos(angle)};
        const double overlap = resting_overlap(sphere, sphere.mass() * g * std::cos(angle));
        dem_min::Simulation s = grain_on_plane(sphere, choice, -overlap, {}, gravity, time_step);
        for (int k = 0; k < 100000; ++k) dem_min::step(s);
        const double v1 = s.grains.vx[0], t1 = s.time();
        for (int k = 0; k < 100000; ++k) dem_min::step(s);
        const double acceleration = (s.grains.vx[0] - v1) / (s.time() - t1);
        const std::string at =
            " at " + std::to_string(share).substr(0, 3) + " times the limit angle";
        if (share < 1.0)
            checks.push_back(check_absolute(
                {"a sphere that resists rolling stays where it is" + at, group, "m/s",
                 "what still rings after 0.2 s, against the 0.16 m/s of free rolling", source},
                0.0, s.grains.vx[0], 1e-6));
        else
            checks.push_back(check_relative(
                {"acceleration down the incline against rolling resistance" + at, group, "m/s^2",
                 "the lever is R less half of an overlap of 3e-5 R, and torque follows the spin",
                 source},
                5.0 / 7.0 * g * (std::sin(angle) - mu_r * std::cos(angle)), acceleration, 2e-4));
    }
}

}  // namespace

std::vector<Check> flight_and_rolling_answers() {
    std::vector<Check> checks;
    free_flight(checks);
    incline(checks);
    return checks;
}

}  // namespace verify
