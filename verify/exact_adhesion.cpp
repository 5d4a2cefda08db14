// SPDX-License-Identifier: MIT
// JKR between two grains: rebound, pull-off, tear-off, sticking.
#include "verify/exact_answers.hpp"
#include "verify/small_systems.hpp"
#include "verify/two_sphere_ode.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace verify {
namespace {

constexpr const char* group = "adhesion";
constexpr const char* jkr_source =
    "Johnson, Kendall & Roberts (1971), Proc. R. Soc. Lond. A 324, 301";
const Sphere sphere;
constexpr double work_of_adhesion =
    5.0;  // J/m^2: grains that stick below 9 cm/s, so that a hit of 1 m/s is felt to adhere

TwoSpheres pair_with(double restitution) {
    return {sphere.e_star, 0.5 * sphere.radius, 0.5 * sphere.mass(), work_of_adhesion, restitution};
}

double sticking_speed(const TwoSpheres& p) { return std::sqrt(2.0 * sticking_work(p) / p.m_star); }

// Rebound speed of the core, 0 where the pair is pulled back. The first touch falls at the share `phase` of a step.
double rebound(double restitution, double speed, double time_step, double phase) {
    dem_min::Simulation s =
        two_grains(sphere, {.work_of_adhesion = work_of_adhesion, .restitution = restitution},
                   speed, (3.0 + phase) * speed * time_step, time_step);
    while (dem_min::pair_count(s) == 0) dem_min::step(s);
    bool parting = false;
    while (dem_min::pair_count(s) > 0) {
        dem_min::step(s);
        const double apart = s.grains.vx[1] - s.grains.vx[0];
        if (parting && apart <= 0.0) return 0.0;
        parting = apart > 0.0;
    }
    return s.grains.vx[1] - s.grains.vx[0];
}

// Birth and tear-off fall somewhere within a step; their errors of first order, F v dt, have either sign and are averaged over
// phases.
double mean_rebound(double restitution, double speed, double time_step) {
    double sum = 0.0;
    for (int k = 0; k < 20; ++k) sum += rebound(restitution, speed, time_step, (k + 0.5) / 20.0);
    return sum / 20.0;
}

void rebounds(std::vector<Check>& checks) {
    for (const double e : {1.0, 0.7})
        for (const double times : {1.5, 4.0}) {
            const TwoSpheres p = pair_with(e);
            const double speed = times * sticking_speed(pair_with(1.0));
            const double expected = integrate_impact(p, speed).rebound_speed;
            const double time_step = tear_off_gap(p) / speed / 100.0;
            const std::string name =
                "rebound speed of adhering spheres at " + std::to_string(times).substr(0, 3) +
                " times the sticking speed, dashpot for e = " + std::to_string(e).substr(0, 3);
            checks.push_back(check_absolute({name, group, "m/s",
                                             "steps of 1/100 of the tear-off gap; errors of first "
                                             "order cancel over 20 phases but for 1/20",
                                             "GSL, Prince-Dormand 8, end located; force law of "
                                             "Johnson, Kendall & Roberts (1971) written anew"},
                                            expected, mean_rebound(e, speed, time_step),
                                            5e-4 * speed));
        }
}

// Grain 1 is drawn from the fixed grain 0 at a given speed, whatever resists; the force is read off the contact.
void pulling(std::vector<Check>& checks) {
    const TwoSpheres p = pair_with(1.0);
    const double places = 1e5, gap = tear_off_gap(p), time_step = 1e-6, way = gap / places;
    dem_min::Simulation s =
        two_grains(sphere, {.work_of_adhesion = work_of_adhesion}, 0.0, -gap, time_step);
    dem_min::step(s);
    double tension = 0.0, farthest = 0.0, last = 0.0;
    while (dem_min::pair_count(s) > 0 && farthest < 3.0 * gap) {
        tension = std::max(tension, -s.grains.fx[1]);
        last = -s.grains.fx[1];
        farthest = std::max(farthest, s.grains.x[1] - s.grains.x[0] - 2.0 * sphere.radius);
        for (double* v : {&s.grains.vx[0], &s.grains.fx[0], &s.grains.fx[1]}) *v = 0.0;
        s.grains.vx[1] = way / time_step;
        dem_min::step(s);
    }
    const double pull_off = 1.5 * std::numbers::pi * work_of_adhesion * p.r_star;
    checks.push_back(check_relative(
        {"deepest tension of a pair drawn apart: 3/2 pi w R*", group, "N",
         "the nearest of 1e5 places to a flat maximum, and round-off of an overlap of 1e-3 R: 1e-9",
         jkr_source},
        pull_off, tension, 1e-8));
    checks.push_back(check_relative(
        {"gap at which a pair drawn apart tears: 3/4 (pi^2 w^2 R*/E*^2)^(1/3)", group, "m",
         "seen before and after a step of 1e-5 of the gap", jkr_source},
        0.75 * std::cbrt(std::pow(std::numbers::pi * work_of_adhesion / p.e_star, 2) * p.r_star),
        farthest, 2.0 / places));
    // With s^2 = a/L: gap ~ s^4 - 2 s, F ~ s^3 (s^3 - 3), fold at s^3 = 1/2. A share q of the gap before the fold F is larger
    // by 1.70 sqrt(q)/2 of itself: 0.27 % at 1e-5, twice that two places before.
    checks.push_back(check_relative(
        {"tension at tear-off: 5/9 of the pull-off force", group, "N",
         "F goes as a square root at the fold: 0.3 % one place of 1e-5 before it", jkr_source},
        5.0 / 9.0 * pull_off, last, 6e-3));
}

// Slowest speed that parts, by bisection.
double critical_speed(double guess, double time_step) {
    double sticks = 0.5 * guess, parts = 2.0 * guess;
    for (int k = 0; k < 45; ++k) {
        const double middle = 0.5 * (sticks + parts);
        (rebound(1.0, middle, time_step, 0.25) > 0.0 ? parts : sticks) = middle;
    }
    return parts;
}

// Three steps, each half of the one before, give order and limit. The touch falls a quarter into a step, at every step and
// speed, so that the error is smooth.
void sticking(std::vector<Check>& checks) {
    const TwoSpheres p = pair_with(1.0);
    const double expected = sticking_speed(p), coarse = tear_off_gap(p) / expected / 20.0;
    const double v1 = critical_speed(expected, coarse), v2 = critical_speed(expected, coarse / 2.0),
                 v4 = critical_speed(expected, coarse / 4.0);
    const double order = std::log2((v1 - v2) / (v2 - v4));
    const double limit = v4 + (v4 - v2) / (std::exp2(order) - 1.0);
    checks.push_back(check_absolute(
        {"order at which the sticking speed converges", group, "1",
         "measured from steps of 1/20, 1/40, 1/80 of the tear-off gap, with a rest of order 2",
         "a contact born within a step: first order"},
        1.0, order, 0.2));
    checks.push_back(check_relative(
        {"sticking speed in the limit of short steps: sqrt(2 W/m*)", group, "m/s",
         "Richardson's limit of the same three steps: what is left is of order 2, (1/80)^2",
         "W by quadrature of the JKR force from touch to fold"},
        expected, limit, 2e-4));
    const double constant = 7.0922 * std::cbrt(std::pow(work_of_adhesion, 5) *
                                               std::pow(p.r_star, 4) / (p.e_star * p.e_star));
    checks.push_back(check_relative(
        {"work of tear-off: 7.0922 (w^5 R*^4/E*^2)^(1/3)", group, "J", "printed to five digits",
         "Thornton & Ning (1998), Powder Technol. 99, 154"},
        constant, sticking_work(p), 1e-5));
}

}  // namespace

std::vector<Check> adhesion_answers() {
    std::vector<Check> checks;
    rebounds(checks);
    pulling(checks);
    sticking(checks);
    return checks;
}

}  // namespace verify
