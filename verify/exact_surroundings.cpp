// SPDX-License-Identifier: MIT
// What acts from afar: falls through a fluid, and a grain on a base that shakes.
#include "verify/exact_answers.hpp"
#include "verify/fall_ode.hpp"
#include "verify/small_systems.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace verify {
namespace {

constexpr const char* group = "surroundings";
constexpr double g = 9.81, pi = std::numbers::pi;

dem_min::Simulation falling(double radius, double density, const dem_min::Fluid& fluid,
                            double time_step) {
    dem_min::Simulation s;
    s.settings = {.time_step = time_step,
                  .gravity = {0.0, 0.0, -g},
                  .fluid = fluid,
                  .lost_below = -std::numeric_limits<double>::infinity()};
    dem_min::insert(s, {{}, {}, {}, radius, density});
    return s;
}

void stokes(std::vector<Check>& checks) {
    const double d = 50e-6, density = 2500.0, eta = 2e-3, lifting = 900.0;
    const double tau = density * d * d / (18.0 * eta);
    const double terminal = (density - lifting) * g * d * d / (18.0 * eta);
    // The drag feels no density, so that Re is 0.
    dem_min::Simulation s = falling(0.5 * d, density, {{1.0, 0.0, eta}, lifting}, tau / 200.0);
    dem_min::advance(s, 200);
    const char* source = "Stokes (1851): m v' = (m - rho_f V) g - 3 pi eta d v";
    const char* reason = "implicit midpoint, tau/dt = 200: (dt/tau)^2/12, of the way (dt/tau)^2";
    checks.push_back(check_relative(
        {"speed of a grain that fell for tau by Stokes' drag", group, "m/s", reason, source},
        terminal * (1.0 - std::exp(-1.0)), -s.grains.vz[0], 3e-6));
    checks.push_back(check_relative(
        {"way of a grain that fell for tau by Stokes' drag", group, "m", reason, source},
        terminal * tau * std::exp(-1.0), -s.grains.z[0], 2.5e-5));
    dem_min::advance(s, 200 * 40);
    checks.push_back(
        check_relative({"terminal velocity by Stokes' drag", group, "m/s",
                        "the scheme has the law's own fixed point; e^-41 is left", source},
                       terminal, -s.grains.vz[0], 1e-12));
}

void falls(std::vector<Check>& checks) {
    struct Fall {
        const char* name;
        FallingSphere sphere;
        double duration;
        const char* reason;
        double tolerance;
    };
    const Fall all[] = {
        {"in air through Re = 1000",
         {2e-3, 2500.0, 1.204, 1.81e-5, g, false},
         1.2,
         "second order with dt/tau = 1e-4; within one step Cd jumps by 0.4 %",
         1e-6},
        {"in water, buoyed up",
         {1e-3, 2500.0, 998.0, 1e-3, g, true},
         0.1,
         "second order with dt/tau = 1/500",
         1e-5},
    };
    const char* source = "Schiller & Naumann (1935), integrated by GSL";
    for (const Fall& fall : all) {
        const FallingSphere& p = fall.sphere;
        const Fallen expected = integrate_fall(p, fall.duration);
        dem_min::Simulation s = falling(
            0.5 * p.diameter, p.density,
            {{1.0, p.fluid_density, p.fluid_viscosity}, p.buoyant ? p.fluid_density : 0.0}, 1e-4);
        dem_min::advance(s, std::lround(fall.duration / 1e-4));
        const std::string of = std::string(" of a fall ") + fall.name;
        checks.push_back(check_relative({"speed" + of, group, "m/s", fall.reason, source},
                                        expected.speed, -s.grains.vz[0], fall.tolerance));
        checks.push_back(check_relative({"way" + of, group, "m", fall.reason, source}, expected.way,
                                        -s.grains.z[0], fall.tolerance));
    }
}

// From a plate at A sin(omega t) a grain lifts off where A omega^2 sin = g, at the plate's place and speed, and flies as Galilei says.
// With u = omega t since then, its height over the plate is A (sin a + u cos a - u^2/(2 G) - sin(a + u)), G = A omega^2/g, sin a = 1/G.
void shaken(std::vector<Check>& checks) {
    const Sphere sphere;
    const double omega = 2.0 * pi * 50.0, time_step = 2e-6;
    const char* source = "Galilei, from where the plate sinks faster than g";
    const auto on_plate = [&](double strength) {
        const double overlap = resting_overlap(sphere, sphere.mass() * g);
        dem_min::Simulation s =
            grain_on_plane(sphere, {.restitution = 0.3}, -overlap, {}, {0.0, 0.0, -g}, time_step);
        s.settings.shaking = {strength * g / (omega * omega), omega, 0.0};
        return s;
    };
    dem_min::Simulation held = on_plate(0.98);
    double fewest = 1.0;
    for (int k = 0; k < 20000; ++k) {
        dem_min::step(held);
        fewest = std::min(fewest, static_cast<double>(wall_contact_count(held)));
    }
    checks.push_back(check_absolute(
        {"contacts, at the least, of a grain on a plate that shakes at 0.98 g", group, "1",
         "the contact swings 70 times as fast as the plate, so that it lags by (1/70)^2 of g",
         source},
        1.0, fewest, 0.0));
    const double strength = 1.5, a = std::asin(1.0 / strength);
    dem_min::Simulation s = on_plate(strength);
    const double amplitude = s.settings.shaking.amplitude;
    for (const double u : {1.0, 2.0, 3.0}) {
        dem_min::advance(s, std::lround((a + u) / omega / time_step) - s.steps);
        const double expected = amplitude * (1.0 / strength + u * std::cos(a) -
                                             0.5 * u * u / strength - std::sin(a + u));
        checks.push_back(
            check_absolute({"height over a plate that shakes at 1.5 g, " +
                                std::to_string(u).substr(0, 1) + " rad after the grain has left it",
                            group, "m",
                            "the last 3 % of the load, under which the contact no longer follows, "
                            "throw the grain by "
                            "another 1e-3 A omega; twice that",
                            source},
                           expected, s.grains.z[0] - sphere.radius, 2e-3 * u * amplitude));
    }
}

}  // namespace

std::vector<Check> surroundings_answers() {
    std::vector<Check> checks;
    stokes(checks), falls(checks), shaken(checks);
    return checks;
}

}  // namespace verify
