// SPDX-License-Identifier: MIT
// Round three: a column that slumps into a heap, over seeds.
#include "verify/lammps_heaps.hpp"

#include "dem_min/random.hpp"
#include "dem_min/simulation.hpp"
#include "dem_min/timestep.hpp"
#include "engines/lammps_run.hpp"
#include "rigs/angle_of_repose.hpp"
#include "verify/against_lammps.hpp"
#include "verify/pile_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <future>
#include <numbers>
#include <utility>

namespace verify {
namespace {

constexpr double power = 0.95;
constexpr double time_limit = 3600.0;  // s, of one heap in LAMMPS: it takes about a minute
constexpr int grains_in_column = 2000;
constexpr std::int64_t steps_at_a_time = 1000;

struct Final {
    std::vector<dem_min::Grain> grains;
    double seconds;
};

double mass_of(const SlumpPowder& p) {
    return p.density * std::numbers::pi / 6.0 * p.diameter * p.diameter * p.diameter;
}

// A square lattice of glued grains, one d apart, tops at z = 0, as in the rig `pile`.
void glue(std::vector<dem_min::Grain>& grains, const SlumpPowder& p) {
    const double d = p.diameter, radius = 0.5 * p.base * d;
    const int most = static_cast<int>(0.5 * p.base) + 1;
    for (int a = -most; a < most; ++a)
        for (int b = -most; b < most; ++b) {
            const double x = (a + 0.5) * d, y = (b + 0.5) * d;
            if (x * x + y * y > radius * radius) continue;
            grains.push_back({{x, y, -0.5 * d}, {}, {}, 0.5 * d, p.density, true});
        }
}

// A cubic lattice 1.15 d apart, turned by a random angle about the axis, each grain moved by up to
// 0.07 d along each axis: none touches another, and no two seeds slump alike.
void stack(std::vector<dem_min::Grain>& grains, const SlumpPowder& p, std::uint64_t seed) {
    const dem_min::RandomStream random{seed, 0};
    const double spacing = 1.15 * p.diameter, radius = 0.5 * p.column * p.diameter;
    const double turn = 0.5 * std::numbers::pi * random.uniform(0);
    const double c = std::cos(turn), s = std::sin(turn);
    const int most = static_cast<int>(radius / spacing) + 1;
    std::uint64_t drawn = 1;
    const auto moved = [&] { return 0.14 * p.diameter * (random.uniform(drawn++) - 0.5); };
    for (int layer = 0, count = 0; count < grains_in_column; ++layer)
        for (int a = -most; a <= most; ++a)
            for (int b = -most; b <= most && count < grains_in_column; ++b) {
                const double x = spacing * a, y = spacing * b;
                if (x * x + y * y > radius * radius) continue;
                const double mx = moved(), my = moved(), mz = moved();
                grains.push_back(
                    {{c * x - s * y + mx, s * x + c * y + my, p.diameter + spacing * layer + mz},
                     {},
                     {},
                     0.5 * p.diameter,
                     p.density,
                     false});
                ++count;
            }
}

Final slumped_here(const engines::Slump& slump, const std::atomic<bool>* stop) {
    const auto start = std::chrono::steady_clock::now();
    dem_min::Simulation s;
    s.settings = {.time_step = slump.time_step,
                  .skin = 0.2 * 2.0 * slump.grains.front().radius,
                  .gravity = {0.0, 0.0, -slump.gravity},
                  .lost_below = slump.box.low.z};
    s.between_grains = s.at_walls = engines::laws(slump.contact);
    for (const dem_min::Grain& g : slump.grains) dem_min::insert(s, g);
    for (std::int64_t k = 0; k < slump.steps; ++k) {
        if (k % steps_at_a_time == 0 && stop != nullptr && stop->load()) throw Interrupted{};
        dem_min::step(s);
    }
    dem_min::check_finite(s);
    Final result{};
    for (std::size_t k = 0; k < s.grains.count(); ++k)
        result.grains.push_back({s.grains.position(k), s.grains.velocity(k), s.grains.spin(k),
                                 s.grains.radius[k], slump.grains.front().density,
                                 s.grains.fixed(k)});
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

Final slumped_in_lammps(const std::filesystem::path& lmp, const engines::Slump& slump,
                        const std::filesystem::path& folder) {
    const auto start = std::chrono::steady_clock::now();
    Final result{engines::run_slump(lmp, slump, folder, time_limit), 0.0};
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

struct Reading {
    std::optional<double> angle_deg;
    double moving, on_base;
};

Reading read(const std::vector<dem_min::Grain>& grains, const SlumpPowder& p) {
    rigs::Heap heap{};
    heap.base_radius = 0.5 * p.base * p.diameter;
    double energy = 0.0;
    for (const dem_min::Grain& g : grains) {
        if (g.fixed || g.position.z < 0.0) continue;  // below the base: on its way out
        heap.centre.push_back(g.position);
        heap.radius.push_back(g.radius);
        energy += 0.5 * contact::dot(g.velocity, g.velocity);
    }
    const auto on_base = static_cast<double>(heap.centre.size());
    const auto angle = rigs::angle_of_repose(rigs::scan(heap), rigs::Estimator::flank_20_80);
    Reading r{{}, energy / std::max(1.0, on_base) / (p.gravity * p.diameter), on_base};
    if (angle) r.angle_deg = angle->angle * 180.0 / std::numbers::pi;
    return r;
}

// FNV-1a, 64 bits: tells whether a remembered result belongs to this deck and start.
std::uint64_t hash_of(const std::string& text) {
    std::uint64_t h = 14695981039346656037u;
    for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 1099511628211u;
    return h;
}

constexpr double no_angle = -1.0;

std::string to_text(const HeapAngle& h, std::uint64_t key) {
    return fmt::format("{:016x} {:a} {:a} {:a} {:a} {:a} {:a} {:a} {:a} {:a} end\n", key,
                       h.ours_deg.value_or(no_angle), h.lammps_deg.value_or(no_angle),
                       h.control_deg.value_or(no_angle), h.ours_moving, h.lammps_moving,
                       h.ours_on_base, h.lammps_on_base, h.ours_seconds, h.lammps_seconds);
}

std::optional<HeapAngle> remembered(const std::filesystem::path& file, std::uint64_t key,
                                    std::uint64_t seed) {
    std::ifstream in(file);
    std::string written_key, word, end;
    std::vector<double> n;
    in >> written_key;
    for (int k = 0; k < 9 && in >> word; ++k) n.push_back(std::strtod(word.c_str(), nullptr));
    if (!(in >> end) || end != "end" || written_key != fmt::format("{:016x}", key)) return {};
    const auto angle = [](double x) { return x == no_angle ? std::optional<double>{} : x; };
    return HeapAngle{seed, angle(n[0]), angle(n[1]), angle(n[2]), n[3],
                     n[4], n[5],        n[6],        n[7],        n[8]};
}

// The control: a core with 80 % of all friction lost. With 40 % lost the angle of this heap moves by
// less than its margin: adhesion holds it up.
engines::Slump with_low_friction(engines::Slump slump) {
    slump.contact.sliding_friction *= 0.2;
    slump.contact.rolling_friction *= 0.2;
    return slump;
}

HeapAngle heap(const std::filesystem::path& lmp, const LammpsCampaign& campaign,
               const SlumpPowder& powder, std::uint64_t seed) {
    const engines::Slump slump = slump_of(powder, seed);
    const std::filesystem::path folder = campaign.folder / fmt::format("heap-{}", seed);
    const std::filesystem::path file = folder / "angle.txt";
    const std::uint64_t key = hash_of(engines::slump_deck(slump) + engines::slump_data(slump) +
                                      engines::slump_deck(with_low_friction(slump)));
    if (campaign.resume)
        if (const auto known = remembered(file, key, seed)) return *known;
    const auto here = [&] {
        return std::pair{slumped_here(slump, campaign.stop),
                         slumped_here(with_low_friction(slump), campaign.stop)};
    };
    auto both = std::async(campaign.threads > 1 ? std::launch::async : std::launch::deferred, here);
    const Final theirs = slumped_in_lammps(lmp, slump, folder);
    const auto [ours, low] = both.get();
    if (campaign.stop != nullptr && campaign.stop->load()) throw Interrupted{};
    const Reading a = read(ours.grains, powder), b = read(theirs.grains, powder);
    const std::optional<double> control = read(low.grains, powder).angle_deg;
    const HeapAngle result{seed,     a.angle_deg, b.angle_deg, control,      a.moving,
                           b.moving, a.on_base,   b.on_base,   ours.seconds, theirs.seconds};
    engines::write_text(file, to_text(result, key));
    return result;
}

statistics::Summary angles_of(const HeapRound& round, std::optional<double> HeapAngle::*side) {
    std::vector<double> values;
    for (const HeapAngle& h : round.heaps)
        if (h.*side) values.push_back(*(h.*side));
    return values.size() < 2 ? statistics::Summary{0.0, 0.0, values.size()}
                             : statistics::summary(values);
}

}  // namespace

engines::LammpsContact contact_of(const SlumpPowder& p) {
    const double d = p.diameter, weight = mass_of(p) * p.gravity, m_star = 0.5 * mass_of(p);
    engines::LammpsContact c{.youngs_modulus = p.elasticity * p.density * p.gravity * d,
                             .poisson_ratio = 0.3};
    const double w = p.bond_number * weight / (1.5 * std::numbers::pi * 0.25 * d);
    c.surface_energy = 0.5 * w;
    c.sliding_friction = p.sliding_friction;
    c.rolling_friction = p.rolling_friction;
    c.rolling_stiffness = 100.0 * weight / d;
    c.rolling_damping = std::sqrt(c.rolling_stiffness * mass_of(p));
    const double at_rest =  // contact radius without load, m
        std::cbrt(4.5 * std::numbers::pi * w * d * d / 16.0 / c.e_star());
    c.eta = p.damping * std::sqrt(2.0 * c.e_star() / (at_rest * m_star));
    return c;
}

engines::Slump slump_of(const SlumpPowder& p, std::uint64_t seed) {
    engines::Slump s{};
    const double d = p.diameter;
    glue(s.grains, p);
    stack(s.grains, p, seed);
    s.contact = contact_of(p);
    s.gravity = p.gravity;
    s.time_step = dem_min::step_limits({.radius = 0.5 * d,
                                        .density = p.density,
                                        .youngs_modulus = s.contact.youngs_modulus,
                                        .poisson_ratio = s.contact.poisson_ratio,
                                        .work_of_adhesion = s.contact.work_of_adhesion(),
                                        .fastest_impact = std::sqrt(2.0 * p.gravity * 25.0 * d)})
                      .shortest();
    s.steps = static_cast<std::int64_t>(p.duration * std::sqrt(d / p.gravity) / s.time_step);
    s.skin = 0.4 * d;
    const double wide = 3.0 * p.base * d;
    s.box = {{-wide, -wide, -3.0 * d}, {wide, wide, 60.0 * d}};
    return s;
}

HeapRound heap_round(const std::filesystem::path& lmp, const LammpsCampaign& campaign) {
    const SlumpPowder powder;
    HeapRound round{};
    round.bond_number = powder.bond_number;
    round.elasticity = powder.elasticity;
    for (int k = 0; k < campaign.heaps; ++k) {
        if (campaign.progress)
            campaign.progress(k, campaign.heaps, fmt::format("heaps in both, {} done", k));
        round.heaps.push_back(
            heap(lmp, campaign, powder, campaign.first_seed + static_cast<std::uint64_t>(k)));
    }
    round.ours = angles_of(round, &HeapAngle::ours_deg);
    round.lammps = angles_of(round, &HeapAngle::lammps_deg);
    round.control = angles_of(round, &HeapAngle::control_deg);
    const HeapMargin& m = round.margin;
    if (std::min({round.ours.count, round.lammps.count, round.control.count}) < 2) return round;
    round.test = statistics::two_one_sided_tests(round.lammps, round.ours, m.angle_deg, m.alpha);
    round.control_test =
        statistics::two_one_sided_tests(round.lammps, round.control, m.angle_deg, m.alpha);
    const double a = round.ours.standard_deviation, b = round.lammps.standard_deviation;
    const double pooled = std::sqrt(0.5 * (a * a + b * b));
    if (pooled > 0.0)
        round.seeds_for_power = statistics::seeds_per_side(pooled, m.angle_deg, power, m.alpha);
    return round;
}

std::vector<Check> heap_checks(const HeapRound& r) {
    const char* group = "LAMMPS, heaps";
    const char* source = "LAMMPS from the same starts; rigs/angle_of_repose, flank_20_80, on both";
    Check same = check_absolute(
        {"angle of repose of a slumped column", group, "deg",
         fmt::format("stated beforehand; difference [{:.2f}, {:.2f}] at 90 %, {} + {} heaps, of "
                     "which {} a side give 95 % power",
                     r.test.interval.low, r.test.interval.high, r.ours.count, r.lammps.count,
                     r.seeds_for_power),
         source},
        r.lammps.mean, r.ours.mean, r.margin.angle_deg);
    same.passed = r.test.equivalent;
    Check control = check_absolute(
        {"a core with 80 % of its friction lost does not pass for LAMMPS", group, "deg",
         fmt::format("the control, which must lie outside; difference [{:.2f}, {:.2f}] at 90 %",
                     r.control_test.interval.low, r.control_test.interval.high),
         source},
        r.lammps.mean, r.control.mean, r.margin.angle_deg);
    control.passed = r.control.count >= 2 && !r.control_test.equivalent;
    return {same, control};
}

}  // namespace verify
