// SPDX-License-Identifier: MIT
#include "prove/terms.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace prove {
namespace {

constexpr double pi = std::numbers::pi;

Unknown of_world(const char* name, double World::*place, double low, double high,
                 bool logarithmic = false, std::vector<double> starts = {}) {
    Unknown u{.name = name};
    u.in_world = place;
    u.low = low, u.high = high, u.logarithmic = logarithmic;
    u.starts = std::move(starts);
    return u;
}

bool records(const std::vector<Setup>& setups, Channel c) {
    for (const Setup& s : setups)
        if (std::find(s.recorded.begin(), s.recorded.end(), c) != s.recorded.end()) return true;
    return false;
}

// The ranges below are those of docs/diagnose.md: what a user of the tool is told that can be.
// A charge of 2.66e-5 C/m^2 is what air at rest holds over a flat surface; small grains hold more.
Term electrostatic(double r) {
    const double most = 2.66e-5 * 4.0 * pi * r * r;
    return {"electrostatic",
            "",
            {of_world("charge", &World::charge, 1e-4 * most, 100.0 * most, true,
                      {0.01 * most, 0.6 * most})}};
}
Term capillary(double r) {
    return {"capillary_bridge",
            "",
            {of_world("surface_tension", &World::surface_tension, 0.005, 0.6, true, {0.006, 0.03}),
             of_world("liquid_volume", &World::liquid_volume, 1e-7 * r * r * r, 0.5 * r * r * r,
                      true, {1e-3 * r * r * r})}};
}
Term adhesion() {
    return {
        "adhesion",
        "",
        {of_world("work_of_adhesion", &World::work_of_adhesion, 1e-4, 10.0, true, {2e-4, 0.03})}};
}
Term drag() {
    return {
        "air_drag", "", {of_world("drag_coefficient", &World::drag, 0.1, 10.0, true, {0.12, 1.0})}};
}
Term rolling() {
    return {
        "rolling_resistance",
        "",
        {of_world("rolling_friction", &World::rolling_friction, 1e-4, 0.5, true, {2e-4, 0.02})}};
}
Term velocity_friction(double v) {
    return {"velocity_dependent_friction",
            "",
            {of_world("friction_velocity", &World::friction_velocity, 3e-3 * v, 3.0 * v, true,
                      {0.05 * v, 0.6 * v}),
             of_world("dynamic_friction", &World::dynamic_friction, 3e-3, 1.2, false, {0.2})}};
}
Term visco() {
    return {"viscoelastic_restitution",
            "",
            {of_world("loss_coefficient", &World::loss_coefficient, 0.01, 0.9, false, {0.3})}};
}
Term plastic(double v) {
    return {"plastic_restitution",
            "",
            {of_world("yield_velocity", &World::yield_velocity, 1e-3 * v, v, true,
                      {0.02 * v, 0.2 * v, 0.9 * v})}};
}
Term compliance() {
    Term t{"tangential_compliance",
           "",
           {of_world("stiffness_ratio", &World::stiffness_ratio, 0.1, 10.0, true, {0.12, 1.0})}};
    t.micro_slip = true;
    return t;
}
// Gaussian about a level plate, as docs/diagnose.md says: somebody has looked at it.
Term tilt(bool incline) {
    Unknown angle = of_world("tilt_angle", &World::tilt_angle, incline ? -0.26 : 0.0, 0.26, false,
                             {incline ? 0.01 : 0.03});
    angle.deviation = 0.06;
    if (incline) return {"tilt", "", {angle}};
    return {"tilt",
            "",
            {angle, of_world("tilt_azimuth", &World::tilt_azimuth, -pi, pi, false, {0.8, 2.3})}};
}
Term vibration(double height) {
    return {"vibration",
            "",
            {of_world("amplitude", &World::amplitude, 1e-5 * height, 0.1 * height, true,
                      {1e-4 * height}),
             of_world("frequency", &World::frequency, 2.0, 120.0, true, {8.0, 20.0, 45.0}),
             of_world("phase", &World::phase, -pi, pi, false, {0.5, -2.0})}};
}

// Gaussian about 1: somebody has calibrated the instrument.
void calibrated(Unknown& u, double deviation) {
    u.mean = 1.0, u.deviation = deviation;
    u.low = 0.5, u.high = 2.0, u.starts = {1.001};
}

void add_scales(const std::vector<Setup>& setups, std::vector<Term>& all) {
    const auto add = [&](std::vector<Channel> group) {
        std::vector<Channel> present;
        std::string names;
        for (const Channel c : group) {
            if (!records(setups, c)) continue;
            present.push_back(c);
            if (!names.empty()) names += ',';
            names += to_string(c);
        }
        if (present.empty()) return;
        Unknown u{.name = "scale", .scaled = group};
        calibrated(u, group.front() == Channel::force ? 0.2 : 0.08);
        all.push_back({"measurement_scale", names, {u}});
    };
    add({Channel::z, Channel::x});
    for (std::size_t c = 2; c < channels; ++c) add({static_cast<Channel>(c)});
}

void add_offsets(const std::vector<Setup>& setups, std::vector<Term>& all) {
    for (std::size_t c = 0; c < channels; ++c) {
        const Channel channel = static_cast<Channel>(c);
        if (!records(setups, channel)) continue;
        double noise = 0.0;
        for (const Setup& s : setups)
            for (std::size_t k = 0; k < s.recorded.size(); ++k)
                if (s.recorded[k] == channel) noise = std::max(noise, s.noise[k]);
        Unknown u{.name = "offset", .shifted = {channel}};
        u.low = -60.0 * noise, u.high = 60.0 * noise, u.starts = {0.1 * noise};
        all.push_back({"measurement_offset", to_string(channel), {u}});
    }
}

std::vector<Term> physical(const std::vector<Setup>& setups) {
    const double r = smallest_radius(setups), v = fastest(setups);
    const Rig rig = setups.front().rig;
    Term van_der_waals{"van_der_waals",
                       "",
                       {of_world("hamaker_constant", &World::hamaker_constant, 1e-21, 2e-18, true,
                                 {1e-20, 1e-18})}};
    switch (rig) {
        case Rig::drop: {
            std::vector<Term> all{drag(),        {"buoyancy"}, adhesion(),
                                  van_der_waals, capillary(r), electrostatic(r),
                                  visco(),       plastic(v),   vibration(setups.front().height),
                                  tilt(false)};
            if (records(setups, Channel::x)) {
                all.push_back(velocity_friction(v));
                all.push_back(compliance());
                all.push_back(rolling());
            }
            return all;
        }
        case Rig::incline:
            return {drag(),           {"buoyancy"}, adhesion(),           capillary(r),
                    electrostatic(r), rolling(),    velocity_friction(v), tilt(true)};
        case Rig::impact:
            return {visco(), plastic(v), velocity_friction(v), compliance(), rolling()};
        case Rig::pull_off:
            break;
    }
    return {adhesion(), van_der_waals, capillary(r), electrostatic(r)};
}

}  // namespace

double smallest_radius(const std::vector<Setup>& setups) {
    double r = std::numeric_limits<double>::infinity();
    for (const Setup& s : setups) r = std::min(r, s.radius());
    return r;
}

double fastest(const std::vector<Setup>& setups) {
    double v = 0.0;
    for (const Setup& s : setups)
        v = std::max(v, std::hypot(s.speed, std::sqrt(2.0 * s.gravity * s.height)));
    return v > 0.0 ? v : 1.0;
}

std::vector<Term> terms(const std::vector<Setup>& setups, const std::vector<std::string>& listed) {
    std::vector<Term> all;
    const auto is_listed = [&](const std::string& name) {
        return std::find(listed.begin(), listed.end(), name) != listed.end();
    };
    for (Term& t : physical(setups)) {
        if (is_listed(t.effect)) continue;
        // Micro-slip is in hertz_mindlin already.
        if (t.effect == "tangential_compliance" && is_listed("hertz_mindlin")) continue;
        all.push_back(std::move(t));
    }
    add_scales(setups, all);
    add_offsets(setups, all);
    const Rig rig = setups.front().rig;
    if (rig == Rig::drop || rig == Rig::incline) {
        Unknown u = of_world("factor", &World::time_factor, 0.5, 2.0);
        calibrated(u, 0.08);
        all.push_back({"time_base", "", {u}});
    }
    return all;
}

void enable(const Term& t, World& w) {
    if (t.effect == "buoyancy") w.buoyancy = 1.0;
    if (t.micro_slip) w.micro_slip = true;
}

std::string unit_of_parameter(const std::string& name) {
    if (name == "work_of_adhesion") return "J/m^2";
    if (name == "hamaker_constant") return "J";
    if (name == "surface_tension") return "N/m";
    if (name == "liquid_volume") return "m^3";
    if (name == "charge") return "C";
    if (name == "loss_coefficient") return "(s/m)^(1/5)";
    if (name == "yield_velocity" || name == "friction_velocity") return "m/s";
    if (name == "tilt_angle" || name == "tilt_azimuth" || name == "phase") return "rad";
    if (name == "amplitude") return "m";
    if (name == "frequency") return "Hz";
    if (name == "offset") return "";
    return "1";
}

std::vector<double> channel_ranges(const std::vector<Setup>& setups,
                                   const Eigen::VectorXd& predicted) {
    std::vector<double> low(channels, std::numeric_limits<double>::infinity());
    std::vector<double> high(channels, -std::numeric_limits<double>::infinity());
    Eigen::Index k = 0;
    for (const Setup& s : setups) {
        for (const Channel c : s.recorded) {
            for (std::size_t row = 0; row < s.at.size(); ++row, ++k) {
                if (!std::isfinite(predicted[k])) continue;
                double &a = low[static_cast<std::size_t>(c)],
                       &b = high[static_cast<std::size_t>(c)];
                a = std::min(a, predicted[k]), b = std::max(b, predicted[k]);
            }
        }
    }
    for (std::size_t c = 0; c < channels; ++c) high[c] = std::max(0.0, high[c] - low[c]);
    return high;
}

}  // namespace prove
