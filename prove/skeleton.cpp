// SPDX-License-Identifier: MIT
#include "prove/skeleton.hpp"

#include "prove/skeleton_draft.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace prove {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

void fluid_physics(SkeletonDraft& d) {
    if (d.dice.chance(0.4)) d.sk.physics.push_back("air_drag"), d.sk.world.drag = 1.0;
    if (d.dice.chance(0.4)) d.sk.physics.push_back("buoyancy"), d.sk.world.buoyancy = 1.0;
}

std::string id_of(const char* stem, int k) { return fmt::format("{}-{}", stem, k + 1); }

Skeleton drops(Dice& dice) {
    SkeletonDraft d = begin_skeleton(Rig::drop, dice);
    d.common.diameter = rounded(dice.log_uniform(0.15e-3, 40e-3), 3);
    d.sk.physics = {"gravity"};
    fluid_physics(d);
    name_law(d.sk);
    const bool sideways = dice.chance(0.6), spins = sideways && dice.chance(0.4);
    d.state("restitution", &World::restitution, rounded(dice.uniform(0.35, 0.92), 3), 0.75, 0.1,
            0.99);
    d.state("sliding_friction", &World::sliding_friction, rounded(dice.uniform(0.08, 0.6), 3),
            sideways ? 0.6 : 0.3, 0.01, 1.0);
    const double lowest = std::max(8e-3, 4.0 * d.common.diameter);
    const Span heights = span_of(dice, lowest, std::max(2.5, 3.0 * lowest), d.broad);
    const int rows = 60 + static_cast<int>(dice.pick(140));
    const double falls = dice.uniform(2.2, 5.5);
    for (int k = 0; k < d.count(); ++k) {
        Setup s = d.grain_of(k);
        s.id = id_of("drop", k);
        s.height = heights.draw(dice);
        if (sideways) s.horizontal_speed = rounded(dice.uniform(0.2, 1.5) * std::sqrt(s.height), 3);
        if (spins) s.spin = rounded(dice.uniform(-1.0, 1.0) * std::sqrt(s.height) / s.diameter, 3);
        const double duration = falls * std::sqrt(2.0 * s.height / s.gravity);
        s.at = sampling_times(dice, duration, rows, d.uneven, d.gaps);
        s.recorded = {Channel::z};
        if (sideways) s.recorded.push_back(Channel::x);
        d.sk.stated.push_back(s);
    }
    d.sk.truth = d.sk.stated;
    if (dice.chance(0.3)) d.uncertain("conditions.height", &Setup::height, 0.004, 0.0, true);
    if (dice.chance(0.2)) {
        const double jitter = dice.uniform(0.5e-3, 3e-3);
        d.uncertain("conditions.release_time", &Setup::release_time, 0.0, jitter, false);
    }
    if (sideways && dice.chance(0.3))
        d.uncertain("conditions.horizontal_speed", &Setup::horizontal_speed, 0.01, 0.0, true);
    return std::move(d.sk);
}

Skeleton inclines(Dice& dice) {
    SkeletonDraft d = begin_skeleton(Rig::incline, dice);
    d.common.diameter = rounded(dice.log_uniform(0.4e-3, 25e-3), 3);
    d.sk.physics = {"gravity"};
    fluid_physics(d);
    name_law(d.sk);
    const double mu = rounded(dice.uniform(0.08, 0.5), 3);
    d.state("sliding_friction", &World::sliding_friction, mu, 0.6, 0.01, 1.0);
    if (dice.chance(0.3)) {
        d.sk.physics.push_back("rolling_resistance");
        d.state("rolling_friction", &World::rolling_friction,
                rounded(dice.log_uniform(0.002, 0.04), 3), 0.7, 1e-4, 0.2);
    }
    const bool spin_seen = dice.chance(0.55);
    const int rows = 50 + static_cast<int>(dice.pick(110));
    const Span steep = span_of(dice, 1.5, 35.0, d.broad);
    for (int k = 0; k < d.count(); ++k) {
        Setup s = d.grain_of(k);
        s.id = id_of("run", k);
        s.angle = steep.draw(dice) * degree;
        s.speed = rounded(dice.uniform(-0.6, 1.2), 3);
        const double rolls = s.speed / s.radius();
        s.spin = rounded(dice.chance(0.4) ? 0.0 : rolls * dice.uniform(-0.4, 1.6), 3);
        s.at = sampling_times(dice, rounded(dice.uniform(0.3, 1.2), 2), rows, d.uneven, d.gaps);
        s.recorded = {Channel::s};
        if (spin_seen) s.recorded.push_back(Channel::spin);
        d.sk.stated.push_back(s);
    }
    d.sk.truth = d.sk.stated;
    if (dice.chance(0.3)) d.uncertain("conditions.angle", &Setup::angle, 0.0, 0.15 * degree, false);
    if (dice.chance(0.25)) d.uncertain("conditions.speed", &Setup::speed, 0.01, 0.002, false);
    return std::move(d.sk);
}

Skeleton impacts(Dice& dice) {
    SkeletonDraft d = begin_skeleton(Rig::impact, dice);
    d.common.diameter = rounded(dice.log_uniform(0.5e-3, 25e-3), 3);
    name_law(d.sk);
    d.state("restitution", &World::restitution, rounded(dice.uniform(0.35, 0.95), 3), 0.75, 0.1,
            0.99);
    d.state("sliding_friction", &World::sliding_friction, rounded(dice.uniform(0.05, 0.6), 3), 0.7,
            0.01, 1.0);
    std::vector<Channel> seen;
    for (const Channel c : {Channel::rebound_angle, Channel::normal_restitution,
                            Channel::tangential_restitution, Channel::rebound_spin})
        if (dice.chance(0.6)) seen.push_back(c);
    if (seen.empty()) seen = {Channel::rebound_angle, Channel::normal_restitution};
    if (seen.size() == 1 && seen.front() != Channel::rebound_spin)
        seen.push_back(Channel::rebound_spin);
    const bool spins = dice.chance(0.4);
    const Span speeds = span_of(dice, 0.3, 12.0, d.broad);
    const int rows = 30 + static_cast<int>(dice.pick(50));
    const double from = dice.uniform(2.0, 10.0), to = dice.uniform(60.0, 84.0);
    for (int k = 0; k < d.count(); ++k) {
        Setup s = d.grain_of(k);
        s.id = id_of("shots", k);
        s.speed = speeds.draw(dice);
        if (spins) s.spin = rounded(dice.uniform(-1.0, 1.0) * s.speed / s.radius(), 3);
        for (int row = 0; row < rows; ++row) {
            double at = from + (to - from) * row / (rows - 1.0);
            if (d.uneven) at += dice.uniform(-0.4, 0.4) * (to - from) / rows;
            if (d.gaps && dice.chance(0.1)) continue;
            s.at.push_back(rounded(at, 5) * degree);
        }
        s.recorded = seen;
        d.sk.stated.push_back(s);
    }
    d.sk.truth = d.sk.stated;
    if (dice.chance(0.3)) d.uncertain("conditions.speed", &Setup::speed, 0.01, 0.0, true);
    return std::move(d.sk);
}

// Ordinates of a force curve: close around the plate, wider towards both ends; out along the same ones.
void ordinates(Setup& s, Dice& dice, int rows, double deep, double far, bool uneven) {
    std::vector<double> way;
    for (int k = 0; k < rows; ++k) {
        double x = static_cast<double>(k) / (rows - 1);
        if (uneven && k > 0 && k < rows - 1) x += dice.uniform(-0.4, 0.4) / rows;
        const double share = 0.35;  // of the rows inside the contact
        const double at = x < 1.0 - share ? far * std::pow(1.0 - x / (1.0 - share), 2.2)
                                          : -deep * (x - 1.0 + share) / share;
        way.push_back(rounded(at, 6));
    }
    s.at = way;
    s.at.insert(s.at.end(), way.rbegin(), way.rend());
    s.retract.assign(way.size(), false);
    s.retract.insert(s.retract.end(), way.size(), true);
}

Skeleton curves(Dice& dice) {
    SkeletonDraft d = begin_skeleton(Rig::pull_off, dice);
    d.common.diameter = rounded(dice.log_uniform(3e-6, 200e-6), 3);
    d.common.grain_on_grain = dice.chance(0.3);
    name_law(d.sk);
    if (dice.chance(0.35)) {
        d.sk.physics.push_back("adhesion");
        d.state("work_of_adhesion", &World::work_of_adhesion,
                rounded(dice.log_uniform(0.01, 0.2), 3), 0.8, 1e-3, 1.0);
    }
    d.state("restitution", &World::restitution, rounded(dice.uniform(0.4, 0.9), 3), 0.0, 0.1, 0.99);
    const bool driven = dice.chance(0.3);
    const double stiffness = rounded(dice.log_uniform(0.5, 60.0), 2);
    const Span loads = span_of(dice, 0.15, 12.0, d.broad);
    const int rows = 50 + static_cast<int>(dice.pick(90));
    const double reach = dice.log_uniform(0.4, 6.0);
    for (int k = 0; k < d.count(); ++k) {
        Setup s = d.grain_of(k);
        s.id = id_of("curve", k);
        const double unit = 1.5 * std::numbers::pi * 0.05 * s.r_star();
        s.preload = rounded(loads.draw(dice) * unit, 3);
        const double k_hertz = 4.0 / 3.0 * s.e_star() * std::sqrt(s.r_star());
        double deep = std::pow(s.preload / k_hertz, 2.0 / 3.0);
        double far = std::max(10e-9, reach * deep);
        if (driven) {
            s.cantilever_stiffness = stiffness;
            deep += s.preload / stiffness;
            const double pull =
                1.5 * std::numbers::pi * s.r_star() * std::max(0.05, d.sk.world.work_of_adhesion);
            far = std::max(far, 2.5 * pull / stiffness);
        }
        ordinates(s, dice, rows, deep, far, d.uneven);
        s.recorded = {Channel::force};
        d.sk.stated.push_back(s);
    }
    d.sk.truth = d.sk.stated;
    if (driven) {
        for (std::size_t e = 0; e < d.sk.stated.size(); ++e) {
            // The base line is nobody's knowledge: a wide prior, and a true one that is not zero.
            const Setup& s = d.sk.stated[e];
            d.sk.truth[e].base_line = 0.03 * s.preload * dice.normal();
            const double span = s.at.front() - s.at[s.at.size() / 2 - 1];
            d.sk.truth[e].base_line_slope = 0.02 * s.preload / span * dice.normal();
            for (const bool slope : {false, true}) {
                Unknown u{.name = std::string(slope ? "base_line_slope@" : "base_line@") + s.id};
                u.in_setup = slope ? &Setup::base_line_slope : &Setup::base_line;
                u.experiment = static_cast<int>(e);
                u.deviation = s.preload / (slope ? span : 1.0);
                u.low = -8.0 * u.deviation, u.high = 8.0 * u.deviation;
                d.sk.nuisances.push_back(u);
            }
        }
    }
    return std::move(d.sk);
}

}  // namespace

Skeleton draw(Rig rig, Dice& dice) {
    switch (rig) {
        case Rig::drop:
            return drops(dice);
        case Rig::incline:
            return inclines(dice);
        case Rig::impact:
            return impacts(dice);
        case Rig::pull_off:
            break;
    }
    return curves(dice);
}

std::vector<Unknown> base_unknowns(const Skeleton& sk,
                                   const std::vector<std::size_t>& experiments) {
    std::vector<Unknown> all;
    for (const Stated& p : sk.parameters) {
        if (!p.free) continue;
        Unknown u{.name = p.name};
        u.in_world = p.place;
        u.low = p.low, u.high = p.high;
        all.push_back(u);
    }
    for (const Unknown& n : sk.nuisances) {
        const auto found = std::find(experiments.begin(), experiments.end(),
                                     static_cast<std::size_t>(n.experiment));
        if (found == experiments.end()) continue;
        all.push_back(n);
        all.back().experiment = static_cast<int>(found - experiments.begin());
    }
    return all;
}

std::vector<std::size_t> with_role(const Skeleton& sk, bool held_out) {
    std::vector<std::size_t> list;
    for (std::size_t e = 0; e < sk.stated.size(); ++e)
        if (sk.stated[e].held_out == held_out) list.push_back(e);
    return list;
}

std::vector<std::size_t> all_experiments(const Skeleton& sk) {
    std::vector<std::size_t> list(sk.stated.size());
    for (std::size_t e = 0; e < list.size(); ++e) list[e] = e;
    return list;
}

std::vector<Setup> chosen(const std::vector<Setup>& all, const std::vector<std::size_t>& list) {
    std::vector<Setup> some;
    for (const std::size_t e : list) some.push_back(all[e]);
    return some;
}

}  // namespace prove
