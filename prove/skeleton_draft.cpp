// SPDX-License-Identifier: MIT
#include "prove/skeleton_draft.hpp"

#include <algorithm>
#include <cmath>

namespace prove {
namespace {

const std::vector<Material>& grains() {
    static const std::vector<Material> table{
        {25.0, 8e6, 0.1},    {60.0, 2e7, 0.2},     {180.0, 5e7, 0.25},    {450.0, 1e9, 0.3},
        {950.0, 8e8, 0.42},  {1100.0, 3e6, 0.48},  {1050.0, 3.2e9, 0.34}, {1180.0, 3e9, 0.37},
        {1400.0, 4e9, 0.35}, {2500.0, 63e9, 0.23}, {3900.0, 370e9, 0.22}, {7800.0, 206e9, 0.29}};
    return table;
}

const std::vector<Material>& plates() {
    static const std::vector<Material> table{
        {2500.0, 70e9, 0.22}, {7800.0, 200e9, 0.28}, {1180.0, 3.1e9, 0.37}, {2700.0, 69e9, 0.33}};
    return table;
}

struct Fluid {
    double density, viscosity;
};

void draw_surroundings(Setup& s, Dice& dice) {
    static const std::vector<Fluid> fluids{{1.204, 1.81e-5}, {1.204, 1.81e-5}, {1.184, 1.84e-5},
                                           {0.166, 1.96e-5}, {1.84, 1.46e-5},  {6.16, 1.52e-5}};
    static const std::vector<double> gravities{9.81, 9.81, 9.79, 9.82};
    const Fluid fluid = dice.of(fluids);
    s.fluid_density = fluid.density, s.fluid_viscosity = fluid.viscosity;
    s.gravity = dice.of(gravities);
}

void set_grain(Setup& s, const Material& m) {
    s.density = m.density, s.youngs_modulus = m.youngs_modulus, s.poisson_ratio = m.poisson_ratio;
}

}  // namespace

Span span_of(Dice& dice, double low, double high, bool broad) {
    const double factor = broad ? 6.0 : 1.25;
    const double start = dice.log_uniform(low, std::max(low * 1.0001, high / factor));
    return {start, std::min(high, start * factor)};
}

// dt rounded to ten microseconds or to three digits, some rows lost or shifted.
std::vector<double> sampling_times(Dice& dice, double duration, int rows, bool uneven, bool gaps) {
    const double dt = rounded(duration / rows, 3);
    std::vector<double> t;
    for (int k = 0; k <= rows; ++k) {
        double at = dt * k;
        if (uneven && k > 0) at += dt * dice.uniform(-0.35, 0.35);
        if (gaps && k > 0 && k < rows && dice.chance(0.1)) continue;
        t.push_back(rounded(at, 6));
    }
    return t;
}

Setup SkeletonDraft::grain_of(int k) {
    Setup s = common;
    s.held_out = last(k);
    if (s.held_out) {  // a judge sees no other grain than the fitted ones
        const Setup& seen = sk.stated[dice.pick(static_cast<std::size_t>(fits))];
        s.diameter = seen.diameter;
        set_grain(s, {seen.density, seen.youngs_modulus, seen.poisson_ratio});
        return s;
    }
    if (other_sizes && k > 0 && broad)
        s.diameter = rounded(common.diameter * dice.log_uniform(0.45, 2.2), 3);
    if (other_materials && k > 0 && broad) set_grain(s, dice.of(materials));
    return s;
}

void SkeletonDraft::state(const char* name, double World::*place, double truth, double free_chance,
                          double low, double high) {
    sk.world.*place = truth;
    Stated p{name, place, truth, dice.chance(free_chance), rounded(low, 2), rounded(high, 3),
             truth};
    const double width = p.high - p.low;
    const bool far = dice.chance(0.25);
    for (int k = 0; k < 50; ++k) {
        p.start =
            rounded(far ? dice.uniform(p.low, p.high)
                        : truth + width * dice.uniform(0.03, 0.2) * (dice.chance(0.5) ? 1.0 : -1.0),
                    3);
        const double off = std::abs(p.start - truth);
        if (p.start > p.low && p.start < p.high && off > (far ? 0.3 : 0.02) * width) break;
    }
    p.start = std::clamp(p.start, p.low, p.high);
    if (!p.free) p.start = truth;
    sk.parameters.push_back(p);
}

// The stated value keeps its digits; the true one differs by a draw from the prior.
void SkeletonDraft::uncertain(const char* name, double Setup::*place, double deviation_share,
                              double absolute, bool not_negative) {
    for (std::size_t e = 0; e < sk.stated.size(); ++e) {
        const double value = sk.stated[e].*place;
        const double deviation = rounded(deviation_share * std::abs(value) + absolute, 2);
        if (!(deviation > 0.0)) continue;
        double truth = value + deviation * dice.normal();
        if (not_negative) truth = std::max(truth, 0.2 * value);
        sk.truth[e].*place = truth;
        Unknown u{.name = std::string(name) + "@" + sk.stated[e].id};
        u.in_setup = place;
        u.experiment = static_cast<int>(e);
        u.mean = value, u.deviation = deviation;
        u.low = value - 8.0 * deviation, u.high = value + 8.0 * deviation;
        if (not_negative) u.low = std::max(u.low, 0.01 * std::abs(value));
        sk.nuisances.push_back(u);
    }
}

SkeletonDraft begin_skeleton(Rig rig, Dice& dice) {
    SkeletonDraft d{.sk = {},
                    .dice = dice,
                    .broad = dice.chance(0.75),
                    .other_sizes = dice.chance(0.55),
                    .other_materials = dice.chance(0.35),
                    .uneven = dice.chance(0.25),
                    .gaps = dice.chance(0.3),
                    .fits = 2 + static_cast<int>(dice.pick(3)),
                    .held_out = 1,
                    .common = {},
                    .materials = grains()};
    if (d.fits == 4 && dice.chance(0.5)) d.held_out = 2;
    d.sk.rig = rig;
    d.common.rig = rig;
    set_grain(d.common, dice.of(d.materials));
    const Material plate = dice.of(plates());
    d.common.plate_youngs_modulus = plate.youngs_modulus;
    d.common.plate_poisson_ratio = plate.poisson_ratio;
    draw_surroundings(d.common, dice);
    d.sk.world.micro_slip = dice.chance(0.5);
    d.sk.states_noise = dice.chance(0.85);
    d.sk.states_numerics = dice.chance(0.15);
    d.sk.hands_over_run = dice.chance(0.5);
    const double kind = dice.uniform();
    d.sk.noise.heavy = kind > 0.5 && kind < 0.75;
    d.sk.noise.correlation = kind >= 0.75 ? rounded(dice.uniform(0.3, 0.9), 2) : 0.0;
    return d;
}

void name_law(Skeleton& sk) {
    sk.physics.push_back(sk.world.micro_slip ? "hertz_mindlin" : "hertz_coulomb");
}

}  // namespace prove
