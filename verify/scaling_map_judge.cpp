// SPDX-License-Identifier: MIT
#include "verify/scaling_map_judge.hpp"

#include "scaling/errors.hpp"
#include "scaling/jkr_estimates.hpp"
#include "statistics/equivalence.hpp"
#include "verify/two_sphere_ode.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace verify {
namespace {

constexpr double alpha = 0.05, power = 0.95;
constexpr double most_seeds = 1e5;

double size_ratio(const MapPile& p) { return p.base_ratio / p.h; }

// Mean height between (share - 0.1) R and (share + 0.1) R, in base diameters; half a grain less than the scanner sees, which
// looks at the tops of spheres (rigs/height_map.hpp).
std::optional<double> height_at(const PileSample& s, double share, double width) {
    double sum = 0.0, area = 0.0;
    for (std::size_t k = 0; k < s.profile_r.size(); ++k) {
        if (std::abs(s.profile_r[k] / (0.5 * width) - share) > 0.1) continue;
        sum += s.profile_r[k] * std::max(0.0, s.profile_z[k] - 0.5);
        area += s.profile_r[k];
    }
    return area > 0.0 ? std::optional(sum / area / width) : std::nullopt;
}

// Largest rise of the mean profile going outwards, in base diameters.
double largest_rise(const PileSample& s, double width) {
    double lowest = INFINITY, rise = 0.0;
    for (const double z : s.profile_z) {
        lowest = std::min(lowest, z);
        rise = std::max(rise, z - lowest);
    }
    return rise / width;
}

constexpr double most_rise = 0.05;  // of the base's diameter, or one grain

// On a base of 20 d the outermost ring of grains, full of gaps, is 19 % of the area, which is what base_covered leaves (rigs/formed.hpp);
// it is more of a narrower one. There the criterion is left out on both sides.
constexpr double narrowest_to_cover = 20.0;  // d

std::vector<MapHeap> without_cover(std::vector<MapHeap> heaps) {
    for (MapHeap& h : heaps) {
        std::erase(h.missed, "base_covered");
        h.formed = h.at_rest && h.missed.empty();
    }
    return heaps;
}

statistics::Summary summary_of(const std::vector<double>& values) {
    if (values.size() < 2) return {values.empty() ? 0.0 : values.front(), 0.0, values.size()};
    return statistics::summary(values);
}

MapVerdict verdict_of(const statistics::Interval& i, double margin) {
    if (i.low > -margin && i.high < margin) return MapVerdict::holds;
    if (i.low > margin || i.high < -margin) return MapVerdict::breaks;
    return MapVerdict::not_decided;
}

// Seeds a side for 95 % power at this spread and this difference: exact inside the margin (statistics::seeds_per_side), and in
// the normal limit outside, n = 2 (2 z_95 sd/(|D| - margin))^2.
std::optional<std::size_t> seeds_for(double sd, double difference, double margin) {
    const double beyond = std::abs(difference) - margin;
    if (sd == 0.0) return 2;
    if (beyond > 0.0) {
        const double z = 1.6448536269514722;
        const double n = std::ceil(2.0 * std::pow(2.0 * z * sd / beyond, 2.0));
        if (n > most_seeds) return std::nullopt;
        return std::max<std::size_t>(2, static_cast<std::size_t>(n));
    }
    try {
        return statistics::seeds_per_side(sd, margin, power, alpha, difference);
    } catch (const scaling::InvalidParameter&) {  // no such number below 100 000
        return std::nullopt;
    }
}

std::vector<double> values_of(const std::vector<MapHeap>& heaps, std::size_t quantity,
                              bool formed_only) {
    std::vector<double> values;
    for (const MapHeap& h : heaps)
        if (h.at_rest && (h.formed || !formed_only) && h.values[quantity])
            values.push_back(*h.values[quantity]);
    return values;
}

// Of the heaps poured: a side forms where two thirds do, and does not where one third or fewer do.
bool forms(const MapSide& s) { return 3 * s.formed >= 2 * s.heaps; }
bool forms_not(const MapSide& s) { return 3 * s.formed <= s.heaps; }

std::string listed(const std::vector<MapQuantity>& quantities, MapVerdict verdict) {
    std::string text;
    for (const MapQuantity& q : quantities)
        if (q.verdict == verdict) text += (text.empty() ? "" : ", ") + q.name;
    return text;
}

void conclude(MapCell& c) {
    const std::string breaks = listed(c.quantities, MapVerdict::breaks),
                      open = listed(c.quantities, MapVerdict::not_decided);
    const std::size_t least = std::min(c.reference.heaps, c.scaled.heaps);
    const bool one_sided =
        (forms(c.reference) && forms_not(c.scaled)) || (forms(c.scaled) && forms_not(c.reference));
    if (least == 0) {
        c.verdict = MapVerdict::not_poured;
        c.why = c.scaled.heaps > 0      ? "no heaps of the reference yet"
                : c.reference.heaps > 0 ? "no heaps but the reference's yet"
                                        : "no heaps yet";
    } else if (least >= 3 && one_sided) {
        c.verdict = MapVerdict::breaks;
        c.why = fmt::format("{} of {} heaps form in the reference, {} of {} here",
                            c.reference.formed, c.reference.heaps, c.scaled.formed, c.scaled.heaps);
    } else if (!breaks.empty()) {
        c.verdict = MapVerdict::breaks;
        c.why = breaks;
    } else if (!open.empty()) {
        c.verdict = MapVerdict::not_decided;
        c.why = open;
    } else {
        c.verdict = MapVerdict::holds;
        c.why = "all quantities";
    }
}

// The five numbers of a pair of reference grains, made dimensionless, in the order of impact_margins().
struct PairOfGrains {
    double e_star, w;  // with d = rho = g = 1
};

std::vector<double> impact_numbers(const PairOfGrains& p, double impact_speed) {
    const double pi = std::numbers::pi, r = 0.5, mass = pi / 6.0;
    const scaling::JkrPair pair{scaling::EnergyPerArea::from_value(p.w),
                                scaling::Pressure::from_value(p.e_star),
                                scaling::Length::from_value(0.5 * r)};
    const TwoSpheres spheres{p.e_star, 0.5 * r, 0.5 * mass, p.w, 0.5};
    const double rebound = integrate_impact(spheres, impact_speed).rebound_speed;
    return {pair.pull_off_force().value() / mass,
            std::sqrt(2.0 * sticking_work(spheres) / (0.5 * mass)), rebound / impact_speed,
            pair.zero_load_contact_radius().value() / r, pair.tear_off_gap().value() / r};
}

}  // namespace

MapHeap map_heap(const PileSample& s, const MapPile& p) {
    const double width = size_ratio(p);
    MapHeap h{.name = s.name,
              .seed = s.seed,
              .setup = {},
              .git = {},
              .at_rest = s.at_rest,
              .formed = false,
              .missed = {},
              .values = {},
              .grains_on_base = s.grains_on_base,
              .grain_steps = s.grain_steps,
              .seconds = s.seconds};
    for (const std::string& criterion : s.missed)
        if (criterion != "apex_near_axis" && criterion != "falls_outwards")
            h.missed.push_back(criterion);
    if (largest_rise(s, width) > std::max(most_rise, 1.0 / width))
        h.missed.emplace_back("falls_outwards");
    h.formed = h.at_rest && h.missed.empty();
    h.values = {s.angle_deg(rigs::Estimator::flank_20_80),
                s.angle_deg(rigs::Estimator::two_h_over_d), s.packing_fraction, s.coordination};
    for (const double share : {0.1, 0.3, 0.5, 0.7}) h.values.push_back(height_at(s, share, width));
    const rigs::PileSetup setup = map_job(p, s.seed).setup;
    h.values.push_back(s.mean_compression / (setup.d * setup.d) /
                       (setup.density * setup.gravity * setup.conditions.base_diameter));
    return h;
}

MapSide map_side(const MapPile& p, const std::vector<MapHeap>& heaps) {
    MapSide side{};
    side.size_ratio = size_ratio(p);
    side.elasticity = p.elasticity * p.softening / p.h;
    side.bond = p.bond * p.w / (p.h * p.h);
    side.grains = map_job(p, 1).setup.conditions.grains;
    side.heaps = heaps.size();
    for (const MapHeap& h : heaps) side.at_rest += h.at_rest, side.formed += h.formed;
    return side;
}

MapQuantity judged(const MapMargin& m, const std::vector<double>& reference,
                   const std::vector<double>& scaled) {
    MapQuantity q{.name = m.name,
                  .unit = m.unit,
                  .reference = summary_of(reference),
                  .scaled = summary_of(scaled),
                  .difference = 0.0,
                  .interval = {-INFINITY, INFINITY},
                  .margin = m.margin,
                  .verdict = MapVerdict::not_decided,
                  .seeds_needed = std::nullopt};
    if (m.relative) q.margin *= std::abs(q.reference.mean);
    if (reference.empty() || scaled.empty()) return q;
    q.difference = q.scaled.mean - q.reference.mean;
    if (m.relative) {  // exact: one value a side
        q.interval = {q.difference, q.difference};
        q.verdict = verdict_of(q.interval, q.margin);
        q.seeds_needed = 1;
        return q;
    }
    if (reference.size() < 2 || scaled.size() < 2) return q;
    const statistics::Equivalence test =
        statistics::two_one_sided_tests(q.reference, q.scaled, q.margin, alpha);
    q.interval = test.interval;
    q.verdict = verdict_of(q.interval, q.margin);
    const double sd = std::sqrt(0.5 * (std::pow(q.reference.standard_deviation, 2.0) +
                                       std::pow(q.scaled.standard_deviation, 2.0)));
    q.seeds_needed = seeds_for(sd, q.difference, q.margin);
    return q;
}

MapCell map_cell(const MapPair& pair, const MapPile& reference, const MapPile& scaled,
                 std::vector<MapHeap> reference_heaps, std::vector<MapHeap> scaled_heaps) {
    if (std::min(size_ratio(reference), size_ratio(scaled)) < narrowest_to_cover) {
        reference_heaps = without_cover(std::move(reference_heaps));
        scaled_heaps = without_cover(std::move(scaled_heaps));
    }
    MapCell c{.study = pair.study,
              .rule = pair.rule,
              .bond = pair.bond,
              .factor = pair.factor,
              .reference = map_side(reference, reference_heaps),
              .scaled = map_side(scaled, scaled_heaps),
              .quantities = {},
              .verdict = MapVerdict::not_decided,
              .why = {}};
    const bool poured = c.reference.heaps > 0 && c.scaled.heaps > 0;
    const bool no_angle = poured && forms_not(c.reference) && forms_not(c.scaled);
    for (std::size_t k = 0; k < map_margins().size(); ++k) {
        const MapMargin& m = map_margins()[k];
        const bool flank = m.name == std::string("angle_flank_20_80");
        if (flank && no_angle) continue;
        c.quantities.push_back(
            judged(m, values_of(reference_heaps, k, flank), values_of(scaled_heaps, k, flank)));
    }
    conclude(c);
    return c;
}

std::vector<MapCell> single_impacts(double bond, double elasticity,
                                    const std::vector<double>& factors) {
    const double nu = 0.25, mass = std::numbers::pi / 6.0;
    const auto pair_of = [&](double softening, double w) {
        return PairOfGrains{elasticity * softening / (2.0 * (1.0 - nu * nu)),
                            bond * mass / (1.5 * std::numbers::pi * 0.25) * w};
    };
    const PairOfGrains reference = pair_of(1.0, 1.0);
    const TwoSpheres spheres{reference.e_star, 0.25, 0.5 * mass, reference.w, 0.5};
    const double speed = 10.0 * std::sqrt(2.0 * sticking_work(spheres) / (0.5 * mass));
    const std::vector<double> expected = impact_numbers(reference, speed);
    std::vector<MapCell> cells;
    for (const double factor : factors)
        for (const MapSoftening& rule : map_softenings) {
            const double softening = 1.0 / factor, w = std::pow(softening, rule.exponent);
            const std::vector<double> got = impact_numbers(pair_of(softening, w), speed);
            MapCell c{.study = "single_impact",
                      .rule = rule.name,
                      .bond = bond,
                      .factor = factor,
                      .reference = {0.0, elasticity, bond, 2, 1, 1, 1},
                      .scaled = {0.0, elasticity * softening, bond * w, 2, 1, 1, 1},
                      .quantities = {},
                      .verdict = MapVerdict::not_decided,
                      .why = {}};
            for (std::size_t k = 0; k < expected.size(); ++k)
                c.quantities.push_back(judged(impact_margins()[k], {expected[k]}, {got[k]}));
            conclude(c);
            cells.push_back(std::move(c));
        }
    return cells;
}

}  // namespace verify
