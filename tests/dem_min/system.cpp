// SPDX-License-Identifier: MIT
#include "tests/dem_min/system.hpp"

#include "dem_min/mesh.hpp"
#include "dem_min/random.hpp"
#include "dem_min/timestep.hpp"
#include "dem_min/walls.hpp"

#include <cmath>
#include <numbers>

namespace samples {
namespace {

using dem_min::Vec3;

Vec3 drawn(const dem_min::RandomStream& stream, std::uint64_t index, double most) {
    const auto number = [&](std::uint64_t k) {
        return most * (2.0 * stream.uniform(3 * index + k) - 1.0);
    };
    return {number(0), number(1), number(2)};
}

double weight(const Powder& p) {  // N
    return p.density * std::numbers::pi / 6.0 * std::pow(p.diameter, 3) * p.gravity;
}

struct Scaler {
    double length, stress, time;

    void operator()(contact::Hertz& law) const { law.e_star *= stress; }
    void operator()(contact::Jkr& law) const {
        law.e_star *= stress;
        law.w *= stress * length;
    }
    void operator()(contact::Mindlin& law) const { law.g_star *= stress; }
    void operator()(contact::RollingSds& law) const {
        law.stiffness *= stress * length;
        law.damping *= stress * length * time;
    }
    void operator()(auto& /*law without a dimension*/) const {}

    void operator()(dem_min::Plane& wall) const {
        wall.point = length * wall.point;
        wall.velocity = (length / time) * wall.velocity;
    }
    void operator()(dem_min::Shell& wall) const {
        wall.r0 *= length, wall.z0 *= length, wall.r1 *= length, wall.z1 *= length;
        wall.rise *= length / time, wall.spin /= time;
    }
    void operator()(dem_min::MeshPatch& wall) const { wall = dem_min::scaled(wall, length); }
};

void scale(dem_min::Laws& laws, const Scaler& scaler) {
    std::visit(scaler, laws.normal);
    std::visit(scaler, laws.tangential);
    std::visit(scaler, laws.rolling);
    laws.twisting.g_star *= scaler.stress;
    laws.bridge.pull_per_radius *= scaler.stress * scaler.length;
    laws.bridge.volume *= scaler.length * scaler.length * scaler.length;
    laws.bridge.rupture_gap *= scaler.length;
    laws.ageing.onset *= scaler.time;
}

}  // namespace

Powder sticky() {
    // 3/2 pi w d/4 = 8 weights of a grain
    const Powder p{.work_of_adhesion = 0.0};
    return {.work_of_adhesion = 8.0 * weight(p) / (1.5 * std::numbers::pi * p.diameter / 4.0)};
}

Powder dry() { return {.work_of_adhesion = 0.0}; }

dem_min::Laws laws(const Powder& p) {
    dem_min::Laws result{contact::Hertz{p.e_star}, contact::Mindlin{p.g_star, p.sliding_friction},
                         contact::NoRolling{}, contact::DampingTsuji1992::from(p.restitution)};
    if (p.work_of_adhesion > 0.0) {
        result.normal = contact::Jkr{p.e_star, p.work_of_adhesion};
        result.twisting = {p.g_star, p.sliding_friction};
    }
    if (p.rolling_friction > 0.0) result.rolling = contact::RollingEpsd{p.rolling_friction, 0.3};
    return result;
}

contact::CapillaryBridge bridge(const Powder& p, double weights) {
    const double volume = 1e-3 * std::pow(0.5 * p.diameter, 3);
    return contact::CapillaryBridge::from(
        scaling::in_si<scaling::EnergyPerArea>(weights * weight(p) /
                                               (std::numbers::pi * p.diameter)),
        scaling::in_si<scaling::Volume>(volume), 0.0);
}

double recommended_step(const Powder& p, double fastest) {
    const double nu = 0.3;
    return dem_min::step_limits({.radius = 0.5 * p.diameter,
                                 .density = p.density,
                                 .youngs_modulus = 2.0 * (1.0 - nu * nu) * p.e_star,
                                 .poisson_ratio = nu,
                                 .work_of_adhesion = p.work_of_adhesion,
                                 .fastest_impact = fastest})
        .shortest();
}

System two_grains(const Powder& p, double speed, double gap, bool oblique) {
    System s{.between_grains = laws(p),
             .at_walls = laws(p),
             .walls = {},
             .grains = {},
             .gravity = 0.0,
             .time_step = recommended_step(p, speed),
             .skin = 0.1 * p.diameter,
             .lost_below = -1e3 * p.diameter};
    const double r = 0.5 * p.diameter, offset = oblique ? 0.6 * r : 0.0;
    const double apart = std::sqrt((2.0 * r + gap) * (2.0 * r + gap) - offset * offset);
    const Vec3 spin = oblique ? Vec3{0.0, 0.7 * speed / r, 0.3 * speed / r} : Vec3{};
    const Vec3 half{0.5 * speed, 0.0, 0.0};
    s.grains.push_back({{-0.5 * apart, 0.0, 0.0}, half, spin, r, p.density, false});
    s.grains.push_back({{0.5 * apart, 0.0, offset}, -half, {}, r, p.density, false});
    return s;
}

System rain(const Powder& p, int count, bool walled, bool polydisperse) {
    const double d = p.diameter, fall = std::sqrt(2.0 * p.gravity * 12.0 * d);
    System s{
        .between_grains = laws(p),
        .at_walls = laws(p),
        .walls = {},
        .grains = {},
        .gravity = p.gravity,
        .time_step = recommended_step(
            {.diameter = polydisperse ? 0.7 * d : d, .work_of_adhesion = p.work_of_adhesion}, fall),
        .skin = 0.1 * d,
        .lost_below = -2.0 * d};
    if (walled) s.walls = {dem_min::disc(3.5 * d, 0.0), dem_min::tube(3.5 * d, 0.0, 0.6 * d)};
    for (int k = 0; !walled && k < 36; ++k)
        s.grains.push_back(
            {{(k % 6 - 2.5) * d, (k / 6 - 2.5) * d, -0.5 * d}, {}, {}, 0.5 * d, p.density, true});
    const dem_min::RandomStream places{7, 0}, spins{7, 1}, sizes{7, 2};
    for (int k = 0; k < count; ++k) {
        const auto index = static_cast<std::uint64_t>(k);
        const double r = polydisperse ? 0.5 * d * (0.7 + 0.6 * sizes.uniform(index)) : 0.5 * d;
        const Vec3 site{(k % 3 - 1.0) * 1.7 * d, (k / 3 % 3 - 1.0) * 1.7 * d,
                        (0.8 + 1.7 * (k / 9)) * d};
        const double swing = std::sqrt(p.gravity * d);
        s.grains.push_back({site + drawn(places, index, 0.15 * d),
                            {0.0, 0.0, -3.0 * swing},
                            drawn(spins, index, swing / d),
                            r,
                            p.density,
                            false});
    }
    return s;
}

System scaled(const System& original, double length, double time) {
    System s = original;
    const double speed = length / time, stress = speed * speed;  // the density is kept
    const Scaler scaler{length, stress, time};
    scale(s.between_grains, scaler);
    scale(s.at_walls, scaler);
    for (dem_min::Wall& wall : s.walls) std::visit(scaler, wall);
    for (dem_min::Grain& grain : s.grains) {
        grain.position = length * grain.position;
        grain.velocity = speed * grain.velocity;
        grain.spin = (1.0 / time) * grain.spin;
        grain.radius *= length;
    }
    s.gravity *= speed / time;
    s.time_step *= time;
    s.skin *= length;
    s.lost_below *= length;
    return s;
}

dem_min::Simulation simulation(const System& system, int threads, bool ledger) {
    dem_min::Simulation s;
    s.settings = {.time_step = system.time_step,
                  .skin = system.skin,
                  .gravity = {0.0, 0.0, -system.gravity},
                  .lost_below = system.lost_below,
                  .threads = threads,
                  .ledger = ledger};
    s.between_grains = system.between_grains;
    s.at_walls = system.at_walls;
    s.walls = system.walls;
    for (const dem_min::Grain& grain : system.grains) dem_min::insert(s, grain);
    return s;
}

}  // namespace samples
