// SPDX-License-Identifier: MIT
// One sphere on a plane: sliding to rolling, and oblique impacts.
#include "verify/exact_answers.hpp"
#include "verify/small_systems.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace verify {
namespace {

constexpr const char* group = "friction";
constexpr double g = 9.81;
constexpr double time_step = 5e-7;  // s, 1/200 of the contact time
const Sphere sphere;

// A sphere set down on the plane, sliding at v without spin: friction mu m g brakes it and spins it up until
// v - mu g t = (5/2) mu g t: t = 2 v/(7 mu g), and it rolls on at 5/7 v.
void sliding_to_rolling(std::vector<Check>& checks) {
    const double mu = 0.3, v = 0.1, overlap = resting_overlap(sphere, sphere.mass() * g);
    for (const bool rigid : {true, false}) {
        const std::string law = rigid ? " (Coulomb)" : " (Mindlin)";
        const ContactChoice choice{
            .restitution = 0.3, .sliding_friction = mu, .rigid_tangential = rigid};
        dem_min::Simulation s =
            grain_on_plane(sphere, choice, -overlap, {v, 0.0, 0.0}, {0.0, 0.0, -g}, time_step);
        double rolling_since = 0.0;
        const double expected = 2.0 * v / (7.0 * mu * g);
        while (s.time() < 2.0 * expected) {
            dem_min::step(s);
            const double slip = s.grains.vx[0] - sphere.radius * s.grains.wy[0];
            if (rolling_since == 0.0 && slip <= 1e-4 * v) rolling_since = s.time();
        }
        const char* source =
            "two lines of mechanics: m dv = -mu m g dt, I domega = mu m g R dt, I = 2/5 m R^2";
        const char* lever =
            "the contact lies half an overlap, 1.6e-5 R, above the lowest point; Mindlin's spring "
            "rings by 1e-4";
        checks.push_back(check_relative({"a sliding sphere ends rolling at 5/7 of its speed" + law,
                                         group, "m/s", lever, source},
                                        5.0 / 7.0 * v, s.grains.vx[0], 5e-4));
        checks.push_back(
            check_relative({"and with the spin of rolling" + law, group, "rad/s", lever, source},
                           5.0 / 7.0 * v / sphere.radius, s.grains.wy[0], 5e-4));
        checks.push_back(check_relative(
            {"a sliding sphere rolls after 2 v/(7 mu g)" + law, group, "s",
             "rolling is called what slips less than 1e-4 v; the first step has no full friction",
             source},
            expected, rolling_since, 1e-3));
    }
}

struct Bounce {
    double v_t, v_n, spin;  // m/s, m/s, rad/s afterwards
};

Bounce bounce(const ContactChoice& choice, double speed, double angle, double spin, double step) {
    const dem_min::Vec3 v{speed * std::sin(angle), 0.0, -speed * std::cos(angle)};
    dem_min::Simulation s =
        grain_on_plane(sphere, choice, 2.5 * speed * std::cos(angle) * step, v, {}, step);
    s.grains.wy[0] = spin;
    do dem_min::step(s);
    while (dem_min::wall_contact_count(s) > 0 || s.grains.vz[0] < 0.0);
    return {s.grains.vx[0], s.grains.vz[0], s.grains.wy[0]};
}

// Where the contact slides throughout, friction takes the impulse mu (1 + e) m v_n: the dashpot's own impulse, the integral
// of c(d) dd over a closed path, is nil, so it does not matter that it is not in the cap.
void gross_sliding(std::vector<Check>& checks) {
    const double mu = 0.1, e = 0.8, speed = 0.05;
    const char* source =
        "impulse and angular impulse; Kharaz, Gorham & Salman (2001), Powder Technol. 120, 281, "
        "sliding regime";
    const char* reason =
        "restitution is met to 1e-4, and the lever is shorter by half of the overlap, at most "
        "8.6e-4 of R (45 deg)";
    for (const double degrees : {45.0, 60.0, 76.0}) {
        const double angle = degrees * std::numbers::pi / 180.0, v_n = speed * std::cos(angle);
        const Bounce got =
            bounce({.restitution = e, .sliding_friction = mu}, speed, angle, 0.0, 2e-8);
        const std::string at = " at " + std::to_string(degrees).substr(0, 2) + " deg";
        const double impulse = mu * (1.0 + e) * v_n;  // over m
        checks.push_back(check_relative(
            {"tangential speed after gross sliding" + at, group, "m/s", reason, source},
            speed * std::sin(angle) - impulse, got.v_t, 2e-4));
        checks.push_back(
            check_relative({"spin after gross sliding" + at, group, "rad/s", reason, source},
                           2.5 * impulse / sphere.radius, got.spin, 1e-3));
    }
}

// At grazing angles a spring pushed backwards by its dashpot would give energy out of nothing.
void no_gain(std::vector<Check>& checks) {
    for (const double e : {0.2, 0.9})
        for (const double spin : {0.0, -800.0, 800.0}) {
            const double angle = 76.0 * std::numbers::pi / 180.0, speed = 1.0;
            const Bounce b =
                bounce({.restitution = e, .sliding_friction = 0.4}, speed, angle, spin, 2e-7);
            const double inertia = 0.4 * sphere.radius * sphere.radius;  // over m
            const double before = speed * speed + inertia * spin * spin;
            const double after = b.v_t * b.v_t + b.v_n * b.v_n + inertia * b.spin * b.spin;
            checks.push_back(check_absolute(
                {"no energy gained at 76 deg, spin " + std::to_string(static_cast<int>(spin)) +
                     " rad/s, e = " + std::to_string(e).substr(0, 3),
                 group, "1", "round-off", "first law of thermodynamics"},
                0.0, std::max(0.0, after / before - 1.0), 1e-12));
        }
}

}  // namespace

std::vector<Check> friction_answers() {
    std::vector<Check> checks;
    sliding_to_rolling(checks);
    gross_sliding(checks);
    no_gain(checks);
    return checks;
}

}  // namespace verify
