// SPDX-License-Identifier: MIT
#include "prove/secret.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prove {
namespace {

constexpr double pi = std::numbers::pi;

std::function<void(World&, double)> physical(const Term& t, const Skeleton& sk, Dice& dice) {
    const double r = smallest_radius(sk.truth), v = fastest(sk.truth);
    const double sign = dice.chance(0.5) ? 1.0 : -1.0;
    const std::string& e = t.effect;
    if (e == "air_drag") return [](World& w, double s) { w.drag = 4.0 * s; };
    if (e == "buoyancy") return [](World& w, double) { w.buoyancy = 1.0; };
    if (e == "adhesion") {
        const double most = sk.rig == Rig::pull_off ? 0.6 : 2.5;
        return [most](World& w, double s) { w.work_of_adhesion = most * s; };
    }
    if (e == "van_der_waals") return [](World& w, double s) { w.hamaker_constant = 2e-18 * s; };
    if (e == "capillary_bridge") {
        const double volume = r * r * r * dice.log_uniform(3e-5, 3e-2);
        return [volume](World& w, double s) {
            w.liquid_volume = volume;
            w.surface_tension = 0.1 * s;
        };
    }
    if (e == "electrostatic") {
        const double most = 2.5 * 2.65e-5 * 4.0 * pi * r * r;
        return [most](World& w, double s) { w.charge = most * std::sqrt(s); };
    }
    if (e == "rolling_resistance") return [](World& w, double s) { w.rolling_friction = 0.15 * s; };
    if (e == "viscoelastic_restitution") {
        return [](World& w, double s) { w.loss_coefficient = 0.6 * s; };
    }
    if (e == "plastic_restitution") {
        return [v](World& w, double s) { w.yield_velocity = v * std::exp(-5.0 * s); };
    }
    if (e == "velocity_dependent_friction") {
        const double at = v * dice.log_uniform(0.03, 0.5);
        return [at, sign](World& w, double s) {
            w.friction_velocity = at;
            w.dynamic_friction =
                std::clamp(w.sliding_friction * (1.0 + 0.95 * sign * s), 3e-3, 1.2);
        };
    }
    if (e == "tangential_compliance") {
        return [](World& w, double s) {
            w.micro_slip = true;
            w.stiffness_ratio = 0.1 / s;
        };
    }
    if (e == "vibration") {
        const double frequency = dice.log_uniform(4.0, 40.0), phase = dice.uniform(-pi, pi);
        // At most twice the weight: beyond that the bounces are chaos, and nobody could name anything.
        const double omega = 2.0 * pi * frequency;
        const double most = std::min(0.05 * sk.truth.front().height,
                                     2.0 * sk.truth.front().gravity / (omega * omega));
        return [frequency, phase, most](World& w, double s) {
            w.frequency = frequency, w.phase = phase, w.amplitude = most * s;
        };
    }
    if (sk.rig == Rig::incline) {
        return [sign](World& w, double s) { w.tilt_angle = sign * 0.09 * s; };
    }
    const double azimuth = dice.chance(0.7) ? (sign > 0.0 ? 0.0 : pi) : dice.uniform(-pi, pi);
    return [azimuth](World& w, double s) { w.tilt_angle = 0.15 * s, w.tilt_azimuth = azimuth; };
}

std::function<void(World&, double)> instrumental(const Term& t, const Skeleton& sk, Dice& dice) {
    const double sign = dice.chance(0.5) ? 1.0 : -1.0;
    const Unknown& u = t.unknowns.front();
    // Up to 2.5 deviations of what is documented for an instrument, and within the range of an offset.
    const double factor = 2.5 * sign * u.deviation;
    if (t.effect == "time_base")
        return [factor](World& w, double s) { w.time_factor = 1.0 + factor * s; };
    if (t.effect == "measurement_scale") {
        return [factor, group = u.scaled](World& w, double s) {
            for (const Channel c : group) w.scale[static_cast<std::size_t>(c)] = 1.0 + factor * s;
        };
    }
    const Channel c = u.shifted.front();
    double widest = 0.0;
    for (const Setup& one : chosen(sk.truth, with_role(sk, false)))
        widest = std::max(
            widest,
            channel_ranges(
                {one}, predict(sk.world, std::vector<Setup>{one}))[static_cast<std::size_t>(c)]);
    const double most = 0.28 * sign * widest;
    return [c, most](World& w, double s) { w.offset[static_cast<std::size_t>(c)] = most * s; };
}

// The weakest that is still worth its name, on the scale of the dial: a third of the drag curve, 1 mJ/m^2, 0.2 per cent, ...
double least_of(const Term& t, Rig rig) {
    if (t.effect == "air_drag") return 0.075;
    if (t.effect == "adhesion") return rig == Rig::pull_off ? 2e-3 : 4e-4;
    if (t.effect == "capillary_bridge") return 0.1;
    if (t.effect == "van_der_waals") return 5e-4;
    if (t.effect == "electrostatic") return 1e-4;
    if (t.effect == "viscoelastic_restitution" || t.effect == "plastic_restitution") return 0.02;
    if (t.effect == "velocity_dependent_friction") return 0.03;
    if (t.effect == "tangential_compliance") return 0.01;  // ten times Mindlin's stiffness
    return 0.005;
}

double idr_at(const Skeleton& sk, const Dial& dial, double s) {
    World w = sk.world;
    dial.turn(w, s);
    return mismatch(sk, w).idr;
}

}  // namespace

std::optional<Dial> dial_for(const Term& t, const Skeleton& sk, Dice& dice) {
    if (t.effect.starts_with("measurement") || t.effect == "time_base")
        return Dial{t, instrumental(t, sk, dice), least_of(t, sk.rig)};
    return Dial{t, physical(t, sk, dice), least_of(t, sk.rig)};
}

std::vector<Outside> outside_kinds(Rig rig) {
    switch (rig) {
        case Rig::drop:
            return {Outside::magnet, Outside::spring_to_middle, Outside::logarithmic_drift,
                    Outside::gravity_step, Outside::angle_restitution};
        case Rig::incline:
            return {Outside::spring_to_middle, Outside::growing_friction,
                    Outside::logarithmic_drift, Outside::gravity_step};
        case Rig::impact:
            return {Outside::angle_restitution};
        case Rig::pull_off:
            break;
    }
    return {Outside::magnet, Outside::stiffening, Outside::oscillating_force};
}

std::optional<Dial> outside_dial(Outside kind, const Skeleton& sk, Dice& dice) {
    const double sign = dice.chance(0.5) ? 1.0 : -1.0;
    const bool two_channels = sk.truth.front().recorded.size() > 1;
    double most = 1.0;
    switch (kind) {
        case Outside::magnet:
            most = sk.rig == Rig::pull_off ? 1.0 : 60.0;
            break;
        case Outside::spring_to_middle:
            if (sk.rig == Rig::drop && !two_channels) return std::nullopt;
            most = 0.5 * sign;
            break;
        case Outside::growing_friction:
            most = 2.0 * sign;
            break;
        case Outside::angle_restitution:
            if (sk.rig == Rig::drop && !two_channels) return std::nullopt;
            most = 0.8;
            break;
        case Outside::logarithmic_drift:
            most =
                0.3 * sign *
                channel_ranges(
                    sk.truth,
                    predict(sk.world,
                            sk.truth))[static_cast<std::size_t>(sk.truth.front().recorded.front())];
            break;
        case Outside::gravity_step:
            most = 0.6 * sign;
            break;
        case Outside::stiffening:
            most = sign;
            break;
        default:
            most = 3.0 * sign;
    }
    return Dial{{"unknown"}, [kind, most](World& w, double s) {
                    w.kind = kind;
                    w.outside = most * s;
                }};
}

std::optional<double> solve_strength(Skeleton& sk, const Dial& dial, double target) {
    constexpr double reach = 3.5;
    const auto scale_noise = [&](double factor) {
        for (std::vector<Setup>* list : {&sk.truth, &sk.stated})
            for (Setup& s : *list)
                for (double& n : s.noise) n = rounded(n * factor, 3);
    };
    if (dial.term.effect == "buoyancy") {
        const double factor = idr_at(sk, dial, 1.0) / target;
        if (!(factor > 1.0 / reach && factor < reach)) return std::nullopt;
        scale_noise(factor);
        return 1.0;
    }
    double low = 0.0, high = 0.0, idr_low = 0.0, idr_high = 0.0, s = std::max(0.05, dial.least);
    for (int k = 0; k < 9; ++k) {
        const double idr = idr_at(sk, dial, s);
        if (!std::isfinite(idr)) return std::nullopt;
        if (std::abs(idr / target - 1.0) < 0.1) return s;
        if (idr < target) {
            low = s, idr_low = idr;
        } else {
            high = s, idr_high = idr;
        }
        if (low == 1.0) break;
        if (high > 0.0 && low > 0.0) {
            // False position in the logarithms, kept off the ends.
            const double share = std::log(target / idr_low) / std::log(idr_high / idr_low);
            s = low * std::pow(high / low, std::clamp(share, 0.15, 0.85));
        } else if (high > 0.0) {
            if (high <= dial.least) break;
            s = std::max(dial.least, high * std::clamp(0.9 * target / idr_high, 0.01, 0.7));
        } else {
            s = std::min(1.0, low * std::clamp(1.1 * target / std::max(idr_low, 1e-9), 1.5, 50.0));
        }
    }
    s = high == 0.0 ? low : (low == 0.0 ? high : std::sqrt(low * high));
    const double factor = idr_at(sk, dial, s) / target;
    if (!(factor > 1.0 / reach && factor < reach)) return std::nullopt;
    scale_noise(factor);
    return s;
}

}  // namespace prove
