// SPDX-License-Identifier: MIT
#include "verify/scaling_map_plan.hpp"

#include "contact/effective.hpp"
#include "scaling/adhesion.hpp"
#include "scaling/scale_map.hpp"
#include "scaling/schemes.hpp"
#include "verify/remembered_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>

namespace verify {
namespace {

constexpr double pi = std::numbers::pi;

// The reference grain. Only groups matter; glass-like numbers keep the files readable.
constexpr double reference_d = 1e-4, density = 2500.0, gravity = 9.81;  // m, kg/m^3, m/s^2
constexpr double poisson_ratio = 0.25;
// With these a heap without adhesion stands at about 30 deg.
constexpr double sliding_friction = 0.5, rolling_friction = 0.1, restitution = 0.5;

constexpr double feed_width = 1.0 / 3.0;  // of the feed disc, in base diameters
// Solid volume fed, in cubes of the base diameter: a cone at 45 deg with 55 % of solid holds 0.07, one at 60 deg with 45 %
// 0.10, so that heaps spill all around.
constexpr double solid_fed = 0.15;
// Solid share of the usual stream where it meets the base, at sqrt(g D).
constexpr double stream_density = 0.05;

// A funnel's mouth is as wide as the base and holds nearly all that is fed; its outlet is a base diameter above the base, clear of
// every heap. Its wall is smoother than the grains and does not hold them.
constexpr double funnel_height = 0.75, outlet_height = 1.0;  // in base diameters
constexpr double funnel_friction = 0.3;

int grains_of(const MapPile& p) {
    const double width = p.base_ratio / p.h;
    return static_cast<int>(
        std::lround(solid_fed * 6.0 / pi / map_mean_cube * width * width * width));
}

// w as a rule asks for: the exponent of h solved from the group that stays (scaling/adhesion.hpp), the apparatus kept.
double w_of(const std::optional<scaling::Invariant>& rule, double h) {
    if (!rule) return 1.0;
    const auto map = scaling::ScaleMap::solve(scaling::named_scheme("coarse_grain"), h);
    return scaling::with_adhesion(map, rule).factor("work_of_adhesion");
}

struct Rule {
    const char* name;
    std::optional<scaling::Invariant> invariant;  // none: w kept
};
const Rule coarse_rules[] = {{"stress_bond", scaling::Invariant::stress_bond},
                             {"weight_bond", scaling::Invariant::weight_bond},
                             {"cohesion_number", scaling::Invariant::cohesion_number},
                             {"none", {}}};

class Builder {
  public:
    explicit Builder(std::string extent) { plan.extent = std::move(extent); }

    // Seeds grow, where a pile is asked for again, to the larger number.
    std::size_t pile(const MapPile& p) {
        for (std::size_t k = 0; k < plan.piles.size(); ++k)
            if (plan.piles[k].name == p.name) {
                plan.piles[k].seeds = std::max(plan.piles[k].seeds, p.seeds);
                return k;
            }
        plan.piles.push_back(p);
        plan.piles.back().block = block;
        return plan.piles.size() - 1;
    }
    void pair(const char* study, const std::string& rule, double factor, std::size_t reference,
              std::size_t scaled) {
        plan.pairs.push_back({study, rule, plan.piles[reference].bond, factor, reference, scaled});
    }
    MapPlan plan{};
    int block = 0;  // of the piles that come next
};

MapPile plain(double bond, double elasticity, double base_ratio, int seeds) {
    return {.name = fmt::format("bond{:g}-e{:g}-base{:g}", bond, elasticity, base_ratio),
            .bond = bond,
            .elasticity = elasticity,
            .base_ratio = base_ratio,
            .seeds = seeds};
}

struct Coarse {
    double elasticity, base_ratio;
    std::vector<double> h;
    std::vector<int> seeds;  // of the reference, then of each h
};

void coarse_graining(Builder& b, const Coarse& c, double bond, std::size_t rules) {
    const MapPile reference = plain(bond, c.elasticity, c.base_ratio, c.seeds[0]);
    const std::size_t from = b.pile(reference);
    for (std::size_t k = c.h.size(); k-- > 0;)
        for (std::size_t r = 0; r < rules; ++r) {
            const Rule& rule = coarse_rules[r];
            MapPile p = reference;
            p.h = c.h[k], p.seeds = c.seeds[k + 1];
            p.w = w_of(rule.invariant, p.h);
            // Without adhesion all rules are one.
            const std::string name = bond == 0.0 ? "none" : rule.name;
            p.name += fmt::format("-h{:g}-{}", p.h, name);
            b.pair("coarse_graining", name, p.h, from, b.pile(p));
            if (bond == 0.0) break;
        }
}

void softening(Builder& b, const MapPile& reference, const std::vector<double>& factors) {
    const std::size_t from = b.pile(reference);
    b.plan.impact_bond = reference.bond, b.plan.impact_elasticity = reference.elasticity;
    b.plan.impact_factors = factors;
    for (std::size_t k = factors.size(); k-- > 0;)
        for (const MapSoftening& rule : map_softenings) {
            MapPile p = reference;
            p.softening = 1.0 / factors[k];
            p.w = std::pow(p.softening, rule.exponent);
            p.name += fmt::format("-softer{:g}-{}", factors[k], rule.name);
            b.pair("softening", rule.name, factors[k], from, b.pile(p));
        }
}

// The first of `values` is the reference; the pile with the value 1 is the plain one.
void vary(Builder& b, const char* study, const MapPile& usual, double MapPile::*member,
          const std::vector<double>& values) {
    const auto with = [&](double value) {
        MapPile p = usual;
        p.*member = value * usual.*member;
        if (value != 1.0) p.name += fmt::format("-{}{:g}", study, value);
        return b.pile(p);
    };
    const std::size_t from = with(values[0]);
    for (std::size_t k = 1; k < values.size(); ++k)
        b.pair(study, "none", values[k] / values[0], from, with(values[k]));
}

// Apparatus and grains alike, the base so many grains wide; the first is the reference.
void base_over_grain(Builder& b, double bond, double elasticity, const std::vector<double>& widths,
                     const std::vector<int>& seeds) {
    const std::size_t from = b.pile(plain(bond, elasticity, widths[0], seeds[0]));
    for (std::size_t k = 1; k < widths.size(); ++k)
        b.pair("base_over_grain", "none", widths[k] / widths[0], from,
               b.pile(plain(bond, elasticity, widths[k], seeds[k])));
}

// Through a funnel's outlet, so many grains wide; the first is the reference.
void outlet_over_grain(Builder& b, const MapPile& usual, const std::vector<double>& outlets) {
    const auto with = [&](double outlet) {
        MapPile p = usual;
        p.outlet = outlet;
        p.name += fmt::format("-outlet{:g}", outlet);
        return b.pile(p);
    };
    const std::size_t from = with(outlets[0]);
    for (std::size_t k = 1; k < outlets.size(); ++k)
        b.pair("outlet_over_grain", "none", outlets[k] / outlets[0], from, with(outlets[k]));
}

void size_effects(Builder& b, const MapPile& usual) {
    vary(b, "drop_height", usual, &MapPile::drop_height, {1.0, 0.5, 2.0, 4.0});
    vary(b, "feed_rate", usual, &MapPile::feed_rate, {0.25, 0.5, 1.0, 2.0, 4.0});
    vary(b, "time_step", usual, &MapPile::time_step, {0.5, 1.0, 1.5, 2.0});
}

MapPlan tiny_plan() {
    Builder b("tiny");
    coarse_graining(b, {1e4, 10.0, {1.25}, {2, 2}}, 10.0, 1);
    b.plan.reference_grains = grains_of(b.plan.piles[0]);
    return b.plan;
}

MapPlan small_plan() {
    Builder b("small");
    const Coarse coarse{1e4, 20.0, {1.25, 2.0}, {6, 6, 8}};
    for (const double bond : {10.0, 0.0}) coarse_graining(b, coarse, bond, 4);
    softening(b, plain(10.0, 1e5, 12.0, 6), {10.0, 100.0});
    base_over_grain(b, 10.0, 1e4, {20.0, 14.0, 10.0}, {6, 6, 8});
    outlet_over_grain(b, plain(0.0, 1e4, 12.0, 6), {6.0, 4.0});
    b.plan.reference_grains = grains_of(b.plan.piles[0]);
    return b.plan;
}

// What asks most first, and cells together with their reference: coarse grains of Bond 10 and 0, whose cost goes as h^-4; the
// effects of size in the apparatus of 24 grains; the other Bond numbers; h = 1.25, nearly as dear as the reference; 72 d.
MapPlan full_plan() {
    Builder b("full");
    const Coarse coarse{1e5, 48.0, {1.5, 2.0, 3.0}, {6, 6, 8, 12}};
    const Coarse fine{1e5, 48.0, {1.25}, {6, 6}};
    const std::vector<double> widths{48.0, 32.0, 24.0, 16.0, 12.0};
    const std::vector<int> seeds{6, 6, 8, 12, 12};
    coarse_graining(b, coarse, 10.0, 4);
    ++b.block;
    coarse_graining(b, coarse, 0.0, 4);
    ++b.block;
    size_effects(b, plain(10.0, 1e5, 24.0, 8));
    for (const double bond : {0.0, 10.0})
        outlet_over_grain(b, plain(bond, 1e5, 24.0, 8), {12.0, 8.0, 6.0, 5.0, 4.0});
    softening(b, plain(10.0, 1e7, 24.0, 8), {10.0, 100.0, 1000.0});
    ++b.block;
    for (const double bond : {10.0, 0.0}) base_over_grain(b, bond, 1e5, widths, seeds);
    for (const double bond : {100.0, 1.0}) {
        ++b.block;
        coarse_graining(b, coarse, bond, 4);
    }
    for (const double bond : {10.0, 0.0, 100.0, 1.0}) {
        ++b.block;
        coarse_graining(b, fine, bond, 4);
    }
    ++b.block;
    base_over_grain(b, 10.0, 1e5, {48.0, 72.0}, {6, 3});
    b.plan.reference_grains = grains_of(plain(10.0, 1e5, 48.0, 1));
    return b.plan;
}

// FNV-1a of the pile's name: seeds of a pile do not move when the plan gets another one.
std::uint64_t own_seeds(const std::string& name) { return fnv1a(name) % 1'000'000 * 1000; }

}  // namespace

PileJob map_job(const MapPile& p, std::uint64_t seed) {
    const double d = reference_d * p.h, base = p.base_ratio * reference_d;
    const contact::Material grain{
        scaling::Pressure::from_value(p.elasticity * p.softening * density * gravity * reference_d),
        poisson_ratio, scaling::Density::from_value(density)};
    // F_po = 3/2 pi w d/4 = bond m g
    const double weight = density * gravity * pi / 6.0 * std::pow(reference_d, 3.0);
    const double w = p.bond * weight / (1.5 * pi * 0.25 * reference_d) * p.w;
    rigs::PileSetup s{};
    s.d = d;
    s.density = density;
    s.gravity = gravity;
    s.grains = {.e_star = contact::e_star(grain, grain).value(),
                .g_star = contact::g_star(grain, grain).value(),
                .work_of_adhesion = w,
                .sliding_friction = sliding_friction,
                .rolling_friction = rolling_friction,
                .restitution = restitution};
    s.walls = s.grains;  // no wall touches this heap, but a funnel's
    const double feed = feed_width * base;
    const double solid_rate = stream_density * pi / 4.0 * feed * feed * std::sqrt(gravity * base);
    s.conditions = {.base = rigs::Base::glued_grains,
                    .base_diameter = base,
                    .rim_height = d,
                    .grains = grains_of(p),
                    .drop_height = p.drop_height * base,
                    .feed_diameter = feed,
                    .feed_rate = p.feed_rate * solid_rate / (pi / 6.0 * map_mean_cube * d * d * d),
                    .funnel = {}};
    if (p.outlet > 0.0) {
        s.walls.work_of_adhesion = 0.0, s.walls.sliding_friction = funnel_friction;
        s.conditions.funnel =
            rigs::Funnel{p.outlet * reference_d, base, funnel_height * base, outlet_height * base};
        s.conditions.feed_diameter = base;
    }
    cases::Grain mixed{};
    mixed.diameter.value = scaling::Length::from_value(d);
    for (const double size : map_sizes) {
        mixed.sizes.emplace_back(scaling::Length::from_value(size * d), 1.0 / std::size(map_sizes));
        mixed.size_material.push_back(cases::material_of_grain);
    }
    rigs::choose_feed(s, mixed, seed);
    rigs::choose_steps(s);
    s.time_step *= p.time_step;
    return {.name = fmt::format("{}-seed{}", p.name, seed), .seed = seed, .setup = std::move(s)};
}

MapPlan map_plan(MapExtent extent) {
    switch (extent) {
        case MapExtent::tiny:
            return tiny_plan();
        case MapExtent::small:
            return small_plan();
        case MapExtent::full:
            break;
    }
    return full_plan();
}

std::vector<MapTurn> map_turns(const MapPlan& plan, std::uint64_t first_seed) {
    constexpr int at_a_time = 3;
    std::vector<MapTurn> turns;
    const auto pour = [&](int block, int from) {  // says whether seeds are left
        bool more = false;
        for (std::size_t k = 0; k < plan.piles.size(); ++k) {
            const MapPile& p = plan.piles[k];
            if (p.block != block) continue;
            for (int seed = from; seed < std::min(from + at_a_time, p.seeds); ++seed)
                turns.push_back(
                    {k, own_seeds(p.name) + first_seed + static_cast<std::uint64_t>(seed)});
            more = more || p.seeds > from + at_a_time;
        }
        return more;
    };
    for (int block = 0; block <= plan.piles.back().block; ++block)
        for (int from = 0; pour(block, from);) from += at_a_time;
    return turns;
}

double expected_cost(const MapPile& p) { return expected_grain_steps(map_job(p, 1).setup); }

}  // namespace verify
