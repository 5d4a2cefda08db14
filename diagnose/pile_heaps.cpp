// SPDX-License-Identifier: MIT
#include "diagnose/pile_heaps.hpp"

#include "diagnose/candidates.hpp"
#include "diagnose/pile_profile.hpp"
#include "rigs/scanner.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace diagnose {

using Eigen::Index;
using Eigen::MatrixXd;

namespace {

constexpr double soft = 1e5;  // E/(rho g d) from which overlaps hardly show in a heap
constexpr double worth_softening = 0.5;
constexpr double may_move = 0.5;                  // of the scatter between heaps
constexpr std::uint64_t first_seed = 0x70696c65;  // far from those that people choose
constexpr std::uint64_t of_check = 2'000'000;

// In place of the low-discrepancy sequence of Roberts (2018): 0 to 1, point k of `dimensions`.
double evenly(std::size_t k, std::size_t dimension, std::size_t dimensions) {
    double phi = 2.0;  // of x^(dimensions + 1) = x + 1
    for (int n = 0; n < 40; ++n)
        phi = std::pow(1.0 + phi, 1.0 / (static_cast<double>(dimensions) + 1.0));
    const double step = std::pow(1.0 / phi, static_cast<double>(dimension) + 1.0);
    const double v = 0.5 + static_cast<double>(k + 1) * step;
    return v - std::floor(v);
}

// E'/E of the softest grains that may stand for these.
double softest(const cases::Case& c, const cases::Experiment& e) {
    const double d = e.grain.diameter.value.value(), rho = e.grain.density.value.value();
    const double weight = rho * e.surroundings.gravity.value() * d;
    if (!c.model.pairs.empty() || !(weight > 0.0)) return 1.0;
    const double factor = soft * weight / e.grain.youngs_modulus.value.value();
    return factor < worth_softening ? factor : 1.0;
}

rigs::Heap poured_here(const rigs::PileSetup& setup) {
    rigs::PileRun run = rigs::begin_pile(setup, 1);
    while (!run.finished) rigs::advance(run, setup, 100'000);
    return rigs::record(run, setup).heap;
}

// Worlds of the first design: the free parameters alone, each effect alone, each two effects once. Each of these has a sequence of
// its own: every third point of one sequence may lie all in a row.
std::vector<rigs::World> first_design(const Apparatus& f, const rigs::World& stated) {
    constexpr std::size_t without = 14, each_free = 6, each_effect = 14;
    std::vector<const Axis*> free, left_out;
    for (const Axis& a : f.axes) (a.effect.empty() ? free : left_out).push_back(&a);
    std::vector<rigs::World> worlds;
    // Point k of the sequence over the free parameters and these effects.
    const auto add = [&](const std::vector<const Axis*>& effects, std::size_t k) {
        rigs::World w = stated;
        const std::size_t dimensions = std::max<std::size_t>(1, free.size() + effects.size());
        for (std::size_t n = 0; n < free.size(); ++n)
            w.parameters[free[n]->parameter] =
                value_at(*free[n], 2.0 * evenly(k, n, dimensions) - 1.0);
        for (std::size_t n = 0; n < effects.size(); ++n) {
            const Axis& a = *effects[n];
            w.physics.insert(a.effect);
            if (a.parameter.empty()) continue;
            w.parameters[a.parameter] =
                value_at(a, 2.0 * evenly(k, free.size() + n, dimensions) - 1.0,
                         a.beside.empty() ? 0.0 : w.parameters[a.beside]);
        }
        worlds.push_back(std::move(w));
    };
    for (std::size_t k = 0; k < without + each_free * free.size(); ++k) add({}, k);
    for (std::size_t k = 0; k < each_effect; ++k)
        for (const Axis* a : left_out) add({a}, k);
    std::size_t k = 0;
    for (std::size_t a = 0; a < left_out.size(); ++a)
        for (std::size_t b = a + 1; b < left_out.size(); ++b) add({left_out[a], left_out[b]}, k++);
    return worlds;
}

// A grain that swings on a sticky base never comes to rest, and the heap is long there.
rigs::PileSetup patient(rigs::PileSetup s) {
    s.longest = std::min(s.longest, s.feed_time.back() + 6.0 * s.rest_duration);
    return s;
}

}  // namespace

bool alike(const rigs::PileSetup& a, const rigs::PileSetup& b) {
    const rigs::PileConditions &x = a.conditions, &y = b.conditions;
    const auto funnel = [](const rigs::PileConditions& c) {
        return c.funnel ? std::vector{c.funnel->outlet_diameter, c.funnel->top_diameter,
                                      c.funnel->height, c.funnel->outlet_height}
                        : std::vector<double>{};
    };
    const auto meshes = [](const rigs::PileConditions& c) {
        std::vector<double> all;
        for (const dem_min::Surface& m : c.meshes)
            for (const contact::Vec3& v : m.vertices) all.insert(all.end(), {v.x, v.y, v.z});
        return all;
    };
    return x.base == y.base && x.base_diameter == y.base_diameter && x.grains == y.grains &&
           x.rim_height == y.rim_height && x.drop_height == y.drop_height && a.d == b.d &&
           a.density == b.density && a.gravity == b.gravity && a.grains.e_star == b.grains.e_star &&
           a.walls.e_star == b.walls.e_star && a.feed_time == b.feed_time && a.feed_x == b.feed_x &&
           a.radius == b.radius && funnel(x) == funnel(y) && meshes(x) == meshes(y);
}

cases::Experiment softened(cases::Experiment e, double factor) {
    e.grain.youngs_modulus.value *= factor;
    e.plate.youngs_modulus *= factor;
    return e;
}

double base_radius(const cases::Experiment& e) {
    return 0.5 * e.conditions.at("base_diameter").quantity<scaling::Length>().value();
}

double noise_of_heights(const cases::Experiment& e) {
    const auto found = e.noise.find("z");
    return found == e.noise.end() ? 0.0 : found->second;
}

std::vector<rigs::Heap> Pourer::pour(const std::vector<rigs::PileSetup>& setups) const {
    poured_ += static_cast<int>(setups.size());
    if (settings_.pour) return settings_.pour(setups);
    std::vector<rigs::Heap> heaps(setups.size());
    in_parallel(setups.size(), settings_.threads,
                [&](std::size_t k) { heaps[k] = poured_here(setups[k]); });
    return heaps;
}

std::vector<rigs::Heap> Pourer::pour(const cases::Experiment& e, const rigs::World& w,
                                     std::uint64_t from, int heaps) const {
    const cases::Case there = in_world(given_, w);
    std::vector<rigs::PileSetup> setups;
    for (int k = 0; k < heaps; ++k)
        setups.push_back(
            patient(rigs::pile_setup(there, e, first_seed + from + static_cast<std::uint64_t>(k))));
    return pour(setups);
}

void Pourer::pour_into(Apparatus& a, const std::vector<rigs::World>& worlds) const {
    std::vector<rigs::PileSetup> setups;
    for (const rigs::World& w : worlds)
        setups.push_back(patient(rigs::pile_setup(in_world(given_, w), a.experiment,
                                                  first_seed + a.worlds.size() + setups.size())));
    const std::vector<rigs::Heap> heaps = pour(setups);
    a.worlds.insert(a.worlds.end(), worlds.begin(), worlds.end());
    a.heaps.insert(a.heaps.end(), heaps.begin(), heaps.end());
}

double Pourer::moved_by(const cases::Experiment& e, double softening) const {
    constexpr int heaps = 12;
    const double stiffer = std::min(10.0, 1.0 / softening);
    const Scan spots = scan_of(*e.recording);
    const Rings rings(spots, base_radius(e), e.grain.diameter.value.value(), 0.0);
    const rigs::World stated = rigs::world_of(given_, e);
    const auto n = static_cast<Index>(rings.count());
    MatrixXd y(2 * heaps, n);
    Index row = 0;
    for (const double factor : {softening, softening * stiffer})
        for (const rigs::Heap& heap : pour(softened(e, factor), stated, of_check, heaps))
            y.row(row++) =
                rings.reduced(rigs::heights_at(heap, spots.azimuth, spots.r), false).head(n);
    const Eigen::RowVectorXd soft_mean = y.topRows(heaps).colwise().mean(),
                             stiff_mean = y.bottomRows(heaps).colwise().mean();
    const Eigen::RowVectorXd variance =
        ((y.topRows(heaps).rowwise() - soft_mean).cwiseAbs2().colwise().sum() +
         (y.bottomRows(heaps).rowwise() - stiff_mean).cwiseAbs2().colwise().sum()) /
        (2.0 * heaps - 2.0);
    // Less what two means of so many heaps differ by anyway.
    const double square =
        ((stiff_mean - soft_mean).cwiseAbs2().array() / variance.array() - 2.0 / heaps).mean();
    const double shown = 1.0 - std::pow(stiffer, -2.0 / 3.0),
                 all = 1.0 - std::pow(softening, 2.0 / 3.0);
    return std::sqrt(std::max(0.0, square)) * all / shown;
}

Apparatus Pourer::apparatus(const cases::Experiment& e) const {
    Apparatus a{.experiment = e, .stated = rigs::pile_setup(given_, e, 1)};
    a.softening = softest(given_, e);
    while (a.softening < 1.0 && (a.moved = moved_by(e, a.softening)) > may_move)
        a.softening = std::min(1.0, 10.0 * a.softening), a.moved = 0.0;
    a.experiment = softened(e, a.softening);
    return a;
}

void Pourer::pour_first(Apparatus& a) const {
    pour_into(a, first_design(a, rigs::world_of(given_, a.experiment)));
}

}  // namespace diagnose
