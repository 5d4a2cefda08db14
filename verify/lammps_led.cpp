// SPDX-License-Identifier: MIT
// Round one: two grains on prescribed ways.
#include "verify/against_lammps.hpp"
#include "verify/lammps_two_grains.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace verify {
namespace {

constexpr const char* group = "LAMMPS, two grains led together and apart";

double separation(const std::array<engines::GrainState, 2>& pair) {
    return contact::norm(pair[1].position - pair[0].position);
}

// Force on the second grain along n, > 0 in compression.
double force_on_second(const std::array<engines::GrainState, 2>& pair) {
    const contact::Vec3 n = (1.0 / separation(pair)) * (pair[1].position - pair[0].position);
    return contact::dot(pair[1].force, n);
}

struct Curve {
    double deepest = 0.0;     // N, < 0: tension
    double ends_at = -1e9;    // m, the widest gap with a force
    std::size_t touches = 0;  // step
};

Curve curve_of(const engines::PairStates& states, double reach) {
    Curve c;
    for (std::size_t k = 0; k < states.size(); ++k) {
        const double force = force_on_second(states[k]);
        if (force == 0.0) continue;
        if (c.touches == 0) c.touches = k;
        c.deepest = std::min(c.deepest, force);
        c.ends_at = std::max(c.ends_at, separation(states[k]) - reach);
    }
    return c;
}

// The law alone, at LAMMPS' own separations, wherever LAMMPS has a force.
double law_apart(const engines::PairStates& lammps, const contact::Jkr& law, double r_star,
                 double reach) {
    double most = 0.0;
    const double scale = law.length_scale(r_star);
    for (const auto& pair : lammps) {
        const double force = force_on_second(pair);
        if (force == 0.0) continue;
        most =
            std::max(most, std::abs(force - law.at(r_star, scale, reach - separation(pair)).force));
    }
    return most;
}

double core_apart(const engines::PairStates& lammps, const engines::PairStates& core) {
    double most = lammps.size() == core.size() ? 0.0 : HUGE_VAL;
    for (std::size_t k = 0; k < std::min(lammps.size(), core.size()); ++k)
        most = std::max(most, std::abs(force_on_second(lammps[k]) - force_on_second(core[k])));
    return most;
}

std::vector<Check> pull_off_checks(const std::filesystem::path& lmp,
                                   const std::filesystem::path& folder) {
    const engines::TwoGrains t = led_pair(120e-6);
    const double reach = t.grains[0].radius + t.grains[1].radius, r_star = 0.25 * reach;
    const contact::Jkr law = std::get<contact::Jkr>(engines::laws(t.contact).normal);
    const auto lammps = engines::run_two_grains(lmp, t, engines::led_deck(t), folder / "led");
    const auto core = led_by_core(t);
    const Curve ours = curve_of(core, reach), theirs = curve_of(lammps, reach);
    const double pull_off = law.pull_off_force(r_star),
                 way = separation(lammps[0]) - separation(lammps[1]);
    const double gap = -law.tear_off_overlap(r_star, law.length_scale(r_star));
    const char* source = "LAMMPS, pair_style granular jkr, forces printed with 17 digits";
    const char* closed = "Johnson, Kendall & Roberts (1971)";
    const char* digits =
        "round-off: separations of 2e-4 m cancel to overlaps of 1e-7 m, 1e-13 of "
        "them, and LAMMPS' roots of a quartic lose some digits more";
    return {
        check_absolute({"force over separation, law against LAMMPS, over the pull-off force", group,
                        "1", digits, source},
                       0.0, law_apart(lammps, law, r_star, reach) / pull_off, 1e-6),
        check_absolute({"force over separation, core against LAMMPS, over the pull-off force",
                        group, "1", digits, source},
                       0.0, core_apart(lammps, core) / pull_off, 1e-6),
        check_relative({"pull-off force, core against LAMMPS", group, "N", digits, source},
                       theirs.deepest, ours.deepest, 1e-6),
        check_relative(
            {"pull-off force of LAMMPS against 3/2 pi w R*", group, "N",
             "the nearest of the steps to a flat minimum: (4/9)(1/400)^2 = 3e-6", closed},
            -pull_off, theirs.deepest, 3e-6),
        check_absolute({"gap at which the force ends, core against LAMMPS", group, "m",
                        "one step of motion", source},
                       theirs.ends_at, ours.ends_at, way),
        check_absolute({"gap at which LAMMPS ends the force, against that of the deepest tension",
                        group, "m", "one step of motion", closed},
                       gap, theirs.ends_at, way),
        check_absolute({"step at which the grains touch, core against LAMMPS", group, "1",
                        "none: the first touch lies half a step from a whole one", source},
                       static_cast<double>(theirs.touches), static_cast<double>(ours.touches), 0.0),
    };
}

// Springs that turn with the normal, load, slide and come back.
std::vector<Check> passing_checks(const std::filesystem::path& lmp,
                                  const std::filesystem::path& folder) {
    const char* source = "LAMMPS, granular jkr, mindlin_rescale and sds, 17 digits";
    std::vector<Check> checks;
    for (const Pass& p :
         {Pass{"passing-sliding", 0.3, 0.0, 0.0}, Pass{"passing-sticking", 10.0, 0.0, 0.0},
          Pass{"passing-rolling", 0.0, 0.1, 1.0}}) {
        const engines::TwoGrains t = passing_pair(p);
        const auto lammps = engines::run_two_grains(lmp, t, engines::led_deck(t), folder / p.name);
        const Apart a = apart(led_by_core(t), lammps, t);
        const auto add = [&](const char* what, double got) {
            checks.push_back(check_absolute(
                {fmt::format("{}, pair {}", what, p.name), group, "1",
                 "LAMMPS turns a spring once it leans out of the plane by 1e-10 of the limit, "
                 "we at every step; round-off of both codes",
                 source},
                0.0, got, 1e-6));
        };
        add("force over the way, over its peak", a.force);
        add("torque over the way, over its peak", a.torque);
    }
    return checks;
}

}  // namespace

std::vector<Check> led_checks(const std::filesystem::path& lmp,
                              const std::filesystem::path& folder) {
    std::vector<Check> checks = pull_off_checks(lmp, folder);
    for (const Check& c : passing_checks(lmp, folder)) checks.push_back(c);
    return checks;
}

}  // namespace verify
