// SPDX-License-Identifier: MIT
#include "prove/heap_family.hpp"

#include "prove/dice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prove {
namespace {

constexpr double gravity = 9.81, pi = std::numbers::pi;
constexpr double softness = 3e4;  // E/(rho g d) of the finest grain: what the powder is

// Grains a second such that a stream from the drop height is 2 % solid where it lands: most find room at its source.
double feed_rate(double d, double drop_height, double feed_diameter) {
    const double speed = std::sqrt(2.0 * gravity * drop_height);
    return 0.02 * pi / 4.0 * feed_diameter * feed_diameter * speed / (pi / 6.0 * d * d * d);
}

Arrangement arrangement(const std::string& id, Powder grain, double factor, double base_diameter,
                        double drop, double feed, int grains) {
    Arrangement a{id, grain, {}, {}, 0.0};
    const double d = a.grain.diameter = rounded(grain.diameter * factor, 3);
    a.rig.base_diameter = base_diameter;
    a.rig.drop_height = rounded(drop * d, 3);
    a.rig.feed_diameter = rounded(feed * d, 3);
    a.rig.feed_rate = rounded(feed_rate(d, a.rig.drop_height, a.rig.feed_diameter), 3);
    a.rig.grains = grains;
    a.noise = rounded(0.05 * d, 2);
    for (std::size_t k = 0; k < spot_azimuths; ++k)
        for (std::size_t j = 0; j < spot_radii; ++j)
            a.spots.push_back(
                {rounded(0.5 * base_diameter * (static_cast<double>(j) + 0.5) /
                             static_cast<double>(spot_radii),
                         6),
                 2.0 * pi * static_cast<double>(k) / static_cast<double>(spot_azimuths)});
    return a;
}

}  // namespace

HeapFamily heap_family(std::uint64_t seed, int family, double size) {
    Dice dice(seed, static_cast<std::uint64_t>(family), 21);
    Powder fine{};
    fine.diameter = rounded(dice.log_uniform(1e-3, 4e-3), 2);
    fine.density = rounded(dice.uniform(1500.0, 4000.0), 2);
    fine.youngs_modulus = rounded(softness * fine.density * gravity * fine.diameter, 3);
    fine.poisson_ratio = rounded(dice.uniform(0.2, 0.35), 2);
    fine.restitution = rounded(dice.uniform(0.3, 0.6), 2);
    const double across = dice.uniform(16.0, 19.0) * std::sqrt(size);
    const double base = rounded(across * fine.diameter, 2);
    // Grains that stick build towers of ten grains and more: the feed stands clear of them.
    constexpr double lowest_drop = 15.0, highest_drop = 18.0;
    const double drop = dice.uniform(lowest_drop, highest_drop), feed = dice.uniform(5.0, 6.0);
    const auto grains = [&](double share) {
        return static_cast<int>(std::lround(1000.0 * size * share));
    };
    HeapFamily f{family,
                 {arrangement("fine", fine, 1.0, base, drop, feed, grains(1.0)),
                  arrangement("coarse", fine, 1.6, base, drop, std::min(feed, 0.5 * across / 1.6),
                              grains(0.35)),
                  arrangement("other", fine, 1.25, base, dice.uniform(lowest_drop, highest_drop),
                              feed, grains(0.6))}};
    if (family % 2 == 1) f.size_spread = 0.1;
    return f;
}

// Strengths that show: adhesion by its pull-off in weights of the finest grain.
std::vector<HeapEffect> heap_effects(const HeapFamily& f) {
    const Powder& g = f.arrangements.front().grain;
    const double weight = g.density * pi / 6.0 * std::pow(g.diameter, 3) * gravity;
    const double one = weight / (1.5 * pi * 0.25 * g.diameter);  // w whose pull-off is one weight
    std::vector<HeapEffect> list{
        {"adhesion", "work_of_adhesion", "J/m^2", 2.0 * one, 12.0 * one},
        {"rolling_resistance", "rolling_friction", "1", 0.1, 0.5},
        {"polydispersity", "size_spread", "1", 0.1, 0.35},
        {"tilt", "tilt_angle", "rad", pi / 180.0 * 3.0, pi / 180.0 * 10.0},
        {"measurement_offset", "offset", "m", 0.4 * g.diameter, 1.6 * g.diameter},
        {"measurement_scale", "scale", "1", 0.1, 0.3}};
    if (f.size_spread > 0.0)
        std::erase_if(list, [](const HeapEffect& e) { return e.name == "polydispersity"; });
    return list;
}

bool acts_among_grains(const std::string& effect) { return !effect.starts_with("measurement_"); }

HeapPhysics with_effect(const HeapFamily& f, const std::string& effect, double strength,
                        double friction, double azimuth) {
    HeapPhysics p{.sliding_friction = friction, .size_spread = f.size_spread};
    if (effect == "adhesion") p.work_of_adhesion = strength;
    if (effect == "rolling_resistance") p.rolling_friction = strength;
    if (effect == "polydispersity") p.size_spread = strength;
    if (effect == "tilt") p.tilt_angle = strength, p.tilt_azimuth = azimuth;
    return p;
}

// Of twenty: 8 nulls, 8 singles, 4 that cancel.
HeapPlan heap_plan(std::uint64_t seed, int number, const HeapFamily& f) {
    Dice dice(seed, static_cast<std::uint64_t>(number), 22);
    const int place = (number - 1) % family_size, round = (number - 1) / family_size;
    HeapPlan p{number, f.number, HeapKind::null, "", 0.0, 0.0, 0.0, 0.0};
    p.friction = rounded(dice.uniform(0.25, 0.75), 3);
    do p.start = rounded(dice.uniform(0.2, 0.8), 2);
    while (std::abs(p.start - p.friction) < 0.1);
    p.azimuth = dice.uniform(0.0, 2.0 * pi);
    const std::vector<HeapEffect> effects = heap_effects(f);
    const int kind = place % 5;  // null, single, null, single, cancelling
    if (kind == 0 || kind == 2) return p;
    const auto pick = static_cast<std::size_t>(place / 5 + 4 * round);
    const HeapEffect& e =
        kind == 4 ? effects[pick % 2] : effects[(2 * pick + (kind == 3 ? 1 : 0)) % effects.size()];
    p.kind = kind == 4 ? HeapKind::cancelling : HeapKind::single;
    p.effect = e.name;
    p.strength = rounded(dice.log_uniform(e.low, e.high), 3);
    if (!acts_among_grains(e.name) && dice.chance(0.5)) p.strength = -p.strength;
    return p;
}

}  // namespace prove
