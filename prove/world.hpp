// SPDX-License-Identifier: MIT
// What acts on a single grain and how strongly, and one experiment with it: numbers only, in SI. Meanings are those of
// docs/effects.md; the way to compute them is this room's own.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace prove {

enum class Rig { drop, incline, impact, pull_off };
enum class Channel {
    z,
    x,
    s,
    spin,
    rebound_angle,
    normal_restitution,
    tangential_restitution,
    rebound_spin,
    force
};
constexpr std::size_t channels = 9;

const char* to_string(Rig);
const char* to_string(Channel);
const char* unit_of(Channel);  // SI

// Effects that the catalogue does not have; `strength` of World::outside sets each.
enum class Outside {
    none,
    magnet,             // a pull to the plate, m g strength (d/(d + gap))^4
    spring_to_middle,   // horizontal or along s: - m g strength s/length
    growing_friction,   // friction coefficient (1 + strength s/length)
    angle_restitution,  // e times 1 - strength sin^2(angle)
    logarithmic_drift,  // reading + strength log(1 + t/tau), tau a tenth of the recording
    gravity_step,       // g times 1 + strength in the second half of the recording
    stiffening,         // force - strength overlap^3 (grain's own scale)
    oscillating_force  // a force over the gap that changes its sign: strength F0 sin(2 pi h/h0) exp(-h/h0)
};
const char* to_string(Outside);

// Absent effects have strength 0, ratio 1, or (loss_coefficient, yield_velocity, friction_velocity) a negative value.
struct World {
    bool micro_slip = true;  // hertz_mindlin or tangential_compliance; else rigid Coulomb
    double drag = 0.0;       // times the curve Cd(Re)
    double buoyancy = 0.0;   // 0 or 1
    double restitution = 1.0, sliding_friction = 0.0, rolling_friction = 0.0;
    double work_of_adhesion = 0.0;
    double hamaker_constant = 0.0;
    double surface_tension = 0.0, liquid_volume = 0.0;
    double charge = 0.0;
    double loss_coefficient = -1.0;
    double yield_velocity = -1.0;
    double friction_velocity = -1.0, dynamic_friction = 0.0;
    double stiffness_ratio = 1.0;
    double tilt_angle = 0.0, tilt_azimuth = 0.0;
    double amplitude = 0.0, frequency = 0.0, phase = 0.0;
    double time_factor = 1.0;
    std::array<double, channels> scale{1, 1, 1, 1, 1, 1, 1, 1, 1};
    std::array<double, channels> offset{};
    Outside kind = Outside::none;
    double outside = 0.0;
};

// How a user's program was run (prove/user_run.hpp); without `used` the motion is exact.
struct UserRun {
    bool used = false;
    double time_step = 0.0, softening = 1.0;
    bool euler = false;
    bool hands_over = false;  // the run is part of the case
};

struct Setup {
    Rig rig = Rig::drop;
    std::string id;
    double diameter = 1e-3, density = 1000.0, youngs_modulus = 1e9, poisson_ratio = 0.3;
    double plate_youngs_modulus = 1e11, plate_poisson_ratio = 0.3;
    double gravity = 9.81, fluid_density = 0.0, fluid_viscosity = 0.0;
    double height = 0.0, speed = 0.0, horizontal_speed = 0.0, spin = 0.0, release_time = 0.0;
    double angle = 0.0;
    double preload = 0.0;
    bool grain_on_grain = false;
    double cantilever_stiffness = 0.0;              // 0: separation is the ordinate
    double base_line = 0.0, base_line_slope = 0.0;  // of a force over a displacement
    std::vector<double> at;     // ordinates: t, angle, separation or displacement
    std::vector<bool> retract;  // pull_off, else empty
    std::vector<Channel> recorded;
    std::vector<double> noise;  // [recorded], standard deviation
    bool held_out = false;
    UserRun user{};

    double radius() const { return 0.5 * diameter; }
    double mass() const;
    double r_star() const { return grain_on_grain ? 0.5 * radius() : radius(); }
    double e_star() const;
    double g_star() const;
    std::size_t size() const { return at.size() * recorded.size(); }
};

// Cd(Re) of Schiller and Naumann (1935), 0.44 above Re = 1000.
double drag_curve(double reynolds);
double reynolds(const Setup&, double speed);
// Deceleration by drag at velocity v, m/s^2, of the sign of v.
double drag_deceleration(const World&, const Setup&, double v);
// The longest first step that an integrator may try: a share of the time in which drag would stop the grain.
double first_step(const World&, const Setup&, double v, double wished);

// Attraction to the plate at the gap h >= 0, N: charge, liquid bridge (where `wet`; the caller looks after its rupture),
// outside kinds that pull.
double attraction(const World&, const Setup&, double gap, bool wet);
double rupture_gap(const World&);  // m

// What the instruments record: [recorded][ordinates], one channel behind the other. Not a number where there is no answer.
std::vector<double> predict(const World&, const Setup&);

}  // namespace prove
