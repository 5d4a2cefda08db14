// SPDX-License-Identifier: MIT
// Head-on impacts of two spheres, against closed forms and GSL's integration.
#include "verify/exact_answers.hpp"
#include "verify/small_systems.hpp"
#include "verify/two_sphere_ode.hpp"

#include <algorithm>
#include <cmath>

namespace verify {
namespace {

constexpr const char* group = "impact";
constexpr double speed = 1.0;  // m/s
constexpr double steps_per_hit = 4000.0;

double duration_scale(const TwoSpheres& p) {
    return std::pow(p.m_star * p.m_star / (p.r_star * p.e_star * p.e_star * speed), 0.2);
}

// The same from the core. The duration counts whole steps.
Impact simulated(const Sphere& sphere, const ContactChoice& choice, double time_step) {
    dem_min::Simulation s = two_grains(sphere, choice, speed, 10.5 * speed * time_step, time_step);
    std::int64_t in_contact = 0;
    double largest = 0.0;
    while (s.steps < 20 || dem_min::pair_count(s) > 0) {
        dem_min::step(s);
        in_contact += dem_min::pair_count(s) > 0;
        largest = std::max(largest, 0.5 * sphere.radius * dem_min::largest_overlap(s));
        if (s.time() > 100.0 * time_step * steps_per_hit) break;
    }
    return {s.grains.vx[1] - s.grains.vx[0], static_cast<double>(in_contact) * time_step, largest};
}

TwoSpheres pair_of(const Sphere& sphere, const ContactChoice& choice) {
    return {sphere.e_star, 0.5 * sphere.radius, 0.5 * sphere.mass(), choice.work_of_adhesion,
            choice.restitution};
}

// Johnson (1985), section 11.4: d_max = (15 m* v^2/(16 sqrt(R*) E*))^(2/5), duration 2.9432 d_max/v with
// 2.9432 = 2 times the integral of dx/sqrt(1 - x^(5/2)) over [0, 1] = (4/5) sqrt(pi) Gamma(2/5)/Gamma(9/10).
void elastic(std::vector<Check>& checks) {
    const Sphere sphere;
    const TwoSpheres p = pair_of(sphere, {});
    const double d_max =
        std::pow(15.0 * p.m_star * speed * speed / (16.0 * std::sqrt(p.r_star) * p.e_star), 0.4);
    const double constant = 0.8 * std::sqrt(std::acos(-1.0)) * std::tgamma(0.4) / std::tgamma(0.9);
    const double time_step = constant * d_max / speed / steps_per_hit;
    const Impact got = simulated(sphere, {}, time_step);
    const char* source = "Johnson (1985), Contact Mechanics, section 11.4, closed form";
    checks.push_back(check_relative({"an elastic impact gives back all of the speed", group, "m/s",
                                     "conservative force, order 2: (pi/4000)^2 is 6e-7", source},
                                    speed, got.rebound_speed, 2e-6));
    checks.push_back(
        check_relative({"the largest overlap of a Hertz impact", group, "m",
                        "order 2 and the nearest of 4000 steps to a flat maximum: 2e-6", source},
                       d_max, got.largest_overlap, 5e-6));
    checks.push_back(check_relative(
        {"the duration of a Hertz impact", group, "s",
         "counted in whole steps, 4000 of them, one more or less at each end", source},
        constant * d_max / speed, got.duration, 2.0 / steps_per_hit));
}

void damped(std::vector<Check>& checks, double e) {
    const Sphere sphere;
    const ContactChoice choice{.restitution = e};
    const TwoSpheres p = pair_of(sphere, choice);
    const double time_step = 3.0 * duration_scale(p) / steps_per_hit;
    const Impact expected = integrate_impact(p, speed), got = simulated(sphere, choice, time_step);
    const std::string with = " (restitution " + std::to_string(e).substr(0, 3) + ")";
    const char* ode = "GSL, Prince-Dormand 8, relative error 1e-12";
    // The force sees velocities half a step old: m* acts as if c dt/2 lighter, and c <= 2 m* pi/T at beta <= 1, so that
    // relative errors are of the size beta pi/8000, a little more for e itself.
    const char* lag =
        "dashpots see velocities half a step old, order 1: pi/4000 is 8e-4, times beta/2";
    checks.push_back(
        check_relative({"two spheres part with the restitution asked for" + with, group, "1", lag,
                        "Antypov & Elliott (2011), EPL 94, 50004: e depends on beta alone"},
                       e, got.rebound_speed / speed, 3e-4));
    checks.push_back(
        check_relative({"rebound speed of a damped impact" + with, group, "m/s", lag, ode},
                       expected.rebound_speed, got.rebound_speed, 3e-4));
    checks.push_back(
        check_relative({"largest overlap of a damped impact" + with, group, "m", lag, ode},
                       expected.largest_overlap, got.largest_overlap, 3e-4));
    checks.push_back(check_relative({"duration of a damped impact" + with, group, "s",
                                     "dashpots half a step old, and whole steps: 4/4000", ode},
                                    expected.duration, got.duration, 4.0 / steps_per_hit));
}

// Error of the rebound speed at a step and at half of it: the order at which it falls.
void order(std::vector<Check>& checks) {
    const Sphere sphere;
    const ContactChoice choice{.restitution = 0.5};
    const TwoSpheres p = pair_of(sphere, choice);
    const double exact = integrate_impact(p, speed).rebound_speed,
                 coarse = 3.0 * duration_scale(p) / 500.0;
    const double error = std::abs(simulated(sphere, choice, coarse).rebound_speed - exact);
    const double finer = std::abs(simulated(sphere, choice, coarse / 4.0).rebound_speed - exact);
    checks.push_back(check_absolute(
        {"the error of a damped impact falls in proportion to the step", group, "1",
         "an order measured between 500 and 2000 steps a hit, with a rest of order 2",
         "velocities in dashpots half a step old: first order"},
        1.0, std::log2(error / finer) / 2.0, 0.15));
}

}  // namespace

std::vector<Check> impact_answers() {
    std::vector<Check> checks;
    elastic(checks);
    for (const double e : {0.3, 0.6, 0.9}) damped(checks, e);
    order(checks);
    return checks;
}

}  // namespace verify
