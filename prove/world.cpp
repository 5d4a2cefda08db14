// SPDX-License-Identifier: MIT
#include "prove/world.hpp"

#include "prove/motions.hpp"
#include "prove/user_run.hpp"

#include <cmath>
#include <numbers>

namespace prove {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double vacuum_permittivity = 8.8541878128e-12;  // F/m, CODATA 2018

double contrast(double modulus, double nu) { return (1.0 - nu * nu) / modulus; }
double compliance(double modulus, double nu) {  // (2 - nu)/G
    return (2.0 - nu) * 2.0 * (1.0 + nu) / modulus;
}

}  // namespace

const char* to_string(Rig rig) {
    static constexpr std::array<const char*, 4> names{"drop", "incline", "impact", "pull_off"};
    return names[static_cast<std::size_t>(rig)];
}

const char* to_string(Channel c) {
    static constexpr std::array<const char*, channels> names{"z",
                                                             "x",
                                                             "s",
                                                             "spin",
                                                             "rebound_angle",
                                                             "normal_restitution",
                                                             "tangential_restitution",
                                                             "rebound_spin",
                                                             "force"};
    return names[static_cast<std::size_t>(c)];
}

const char* unit_of(Channel c) {
    static constexpr std::array<const char*, channels> units{"m", "m", "m",     "rad/s", "rad",
                                                             "1", "1", "rad/s", "N"};
    return units[static_cast<std::size_t>(c)];
}

const char* to_string(Outside kind) {
    static constexpr std::array<const char*, 9> names{"none",
                                                      "magnet",
                                                      "spring to the middle",
                                                      "friction that grows along the way",
                                                      "restitution that depends on the angle",
                                                      "drift with the logarithm of time",
                                                      "step in gravity",
                                                      "stiffening contact",
                                                      "force that oscillates over the gap"};
    return names[static_cast<std::size_t>(kind)];
}

double Setup::mass() const { return density * pi / 6.0 * diameter * diameter * diameter; }

double Setup::e_star() const {
    const double other = grain_on_grain ? contrast(youngs_modulus, poisson_ratio)
                                        : contrast(plate_youngs_modulus, plate_poisson_ratio);
    return 1.0 / (contrast(youngs_modulus, poisson_ratio) + other);
}

double Setup::g_star() const {
    const double other = grain_on_grain ? compliance(youngs_modulus, poisson_ratio)
                                        : compliance(plate_youngs_modulus, plate_poisson_ratio);
    return 1.0 / (compliance(youngs_modulus, poisson_ratio) + other);
}

double drag_curve(double re) {
    return re > 1000.0 ? 0.44 : 24.0 / re * (1.0 + 0.15 * std::pow(re, 0.687));
}

double reynolds(const Setup& s, double speed) {
    return s.fluid_density * std::abs(speed) * s.diameter / s.fluid_viscosity;
}

double drag_deceleration(const World& w, const Setup& s, double v) {
    if (w.drag == 0.0 || v == 0.0 || s.fluid_viscosity <= 0.0) return 0.0;
    const double re = reynolds(s, v);
    // Below Re = 1000 as a multiple of Stokes' law, which is finite at rest.
    const double force = re > 1000.0 ? 0.5 * s.fluid_density * drag_curve(re) * pi * s.radius() *
                                           s.radius() * v * std::abs(v)
                                     : 3.0 * pi * s.fluid_viscosity * s.diameter * v *
                                           (1.0 + 0.15 * std::pow(re, 0.687));
    return w.drag * force / s.mass();
}

double first_step(const World& w, const Setup& s, double v, double wished) {
    const double speed = std::max(std::abs(v), 1e-6);
    const double rate = drag_deceleration(w, s, speed) / speed;
    return rate > 0.0 ? std::min(wished, 0.3 / rate) : wished;
}

double rupture_gap(const World& w) { return std::cbrt(w.liquid_volume); }

double attraction(const World& w, const Setup& s, double gap, bool wet) {
    const double h = std::max(gap, 0.0), r = s.radius();
    double pull = 0.0;
    if (w.charge != 0.0) {
        const double q2 = w.charge * w.charge / (pi * vacuum_permittivity);
        pull += s.grain_on_grain ? -q2 / (4.0 * (2.0 * r + h) * (2.0 * r + h))
                                 : q2 / (16.0 * (r + h) * (r + h));
    }
    if (wet && w.surface_tension > 0.0) {
        const double rs = s.r_star();
        pull += 4.0 * pi * w.surface_tension * rs *
                (1.0 - h / std::sqrt(h * h + w.liquid_volume / (pi * rs)));
    }
    if (w.kind == Outside::magnet) {
        const double near = s.diameter / (s.diameter + h);
        pull += w.outside * s.mass() * s.gravity * near * near * near * near;
    }
    return pull;
}

std::vector<double> predict(const World& w, const Setup& s) {
    std::vector<double> all;
    if (s.user.used) return user_run(w, s);
    switch (s.rig) {
        case Rig::drop:
            all = drop(w, s);
            break;
        case Rig::incline:
            all = incline(w, s);
            break;
        case Rig::impact:
            all = impact(w, s);
            break;
        case Rig::pull_off:
            all = pull_off(w, s);
            break;
    }
    const std::size_t rows = s.at.size();
    for (std::size_t c = 0; c < s.recorded.size(); ++c) {
        const std::size_t channel = static_cast<std::size_t>(s.recorded[c]);
        for (std::size_t k = 0; k < rows; ++k) {
            double& y = all[c * rows + k];
            if (w.kind == Outside::logarithmic_drift) {
                const double span = s.at.back() - s.at.front();
                y += w.outside * std::log1p((s.at[k] - s.at.front()) / (0.1 * span));
            }
            y = w.scale[channel] * y + w.offset[channel];
        }
    }
    return all;
}

}  // namespace prove
