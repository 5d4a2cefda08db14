// SPDX-License-Identifier: MIT
// Round two: two grains thrown at one another, where the rules coincide and where they do not.
#include "verify/against_lammps.hpp"
#include "verify/lammps_two_grains.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace verify {
namespace {

constexpr const char* group = "LAMMPS, oblique impacts";

Apart compared(const std::filesystem::path& lmp, const std::filesystem::path& folder,
               const Throw& c) {
    const engines::TwoGrains t = thrown_pair(c);
    const std::string deck = c.wall ? engines::thrown_at_wall_deck(t) : engines::thrown_deck(t);
    const auto lammps = engines::run_two_grains(lmp, t, deck, folder / c.name);
    return apart(thrown_by_core(t, c.wall), lammps, t);
}

// Under all of these the two codes have one rule: no tangential dashpot where the contact slides,
// and an overlap so small that it does not matter whether it is taken off the lever of the spin.
std::vector<Throw> throws() {
    return {
        {.name = "05-deg", .angle_deg = 5.0},
        {.name = "20-deg", .angle_deg = 20.0},
        {.name = "40-deg", .angle_deg = 40.0},
        {.name = "60-deg", .angle_deg = 60.0},
        {.name = "75-deg", .angle_deg = 75.0},
        {.name = "40-deg-with-spin", .angle_deg = 40.0, .spin = 1.0},
        {.name = "40-deg-damped", .angle_deg = 40.0, .damping = 0.3, .spin = 1.0},
        {.name = "20-deg-damped-sticking",
         .angle_deg = 20.0,
         .sliding_friction = 10.0,
         .damping = 0.3,
         .tangential_ratio = 0.5},
        {.name = "40-deg-without-adhesion", .angle_deg = 40.0, .adhesion = 0.0, .spin = 1.0},
        // LAMMPS' wall has E* = E/(2 (1 - nu)) and, for NULL, half of k_t: see rule_differences.
        {.name = "40-deg-at-wall-without-adhesion",
         .angle_deg = 40.0,
         .adhesion = 0.0,
         .spin = 1.0,
         .wall = true,
         .poisson_ratio = 0.0,
         .stiffness_as_number = true},
    };
}

}  // namespace

std::vector<Check> thrown_checks(const std::filesystem::path& lmp,
                                 const std::filesystem::path& folder) {
    const char* source = "LAMMPS, granular mindlin_rescale, sds and nve/sphere, 17 digits";
    const char* reason =
        "spin in the slip velocity: LAMMPS takes R, we the lever R - overlap/2, 1.5e-7 of it here";
    std::vector<Check> checks;
    for (const Throw& c : throws()) {
        const Apart a = compared(lmp, folder, c);
        const auto add = [&](const char* what, double got) {
            checks.push_back(check_absolute(
                {fmt::format("{}, impact {}", what, c.name), group, "1", reason, source}, 0.0, got,
                1e-6));
        };
        add("force over time, over its peak", a.force);
        add("velocity over time, over the speed of approach", a.velocity);
        add("spin over time, over that speed over R", a.spin);
    }
    return checks;
}

namespace {

// What one thrown pair shows of a rule that differs.
RuleDifference shown_by(const std::filesystem::path& lmp, const std::filesystem::path& folder,
                        const Throw& c, RuleDifference d) {
    d.measure = "largest difference of force or torque, over the peak of each";
    const Apart a = compared(lmp, folder, c);
    d.size = std::max(a.force, a.torque);
    if (!std::isfinite(d.size)) d.size = HUGE_VAL;  // LAMMPS' force is not a number
    return d;
}

// A list that is made anew while the contact is stretched: how much of the gap LAMMPS loses.
RuleDifference lost_with_the_list(const std::filesystem::path& lmp,
                                  const std::filesystem::path& folder) {
    const auto widest = [&](double skin, const char* name) {
        const engines::TwoGrains t = led_pair(skin);
        const double reach = t.grains[0].radius + t.grains[1].radius;
        double gap = -reach;
        for (const auto& pair :
             engines::run_two_grains(lmp, t, engines::led_deck(t), folder / name))
            if (contact::norm(pair[1].force) > 0.0)
                gap = std::max(gap, contact::norm(pair[1].position - pair[0].position) - reach);
        return gap;
    };
    const double thick = widest(120e-6, "led-thick-list"), thin = widest(1.2e-8, "led-thin-list");
    return {.rule = "a stretched contact when the neighbour list is made anew",
            .ours = "kept",
            .theirs = "ended",
            .conditions = "pair led apart, margin of the list 1e-4 R",
            .measure = "gap lost, over the gap of the deepest tension",
            .size = (thick - thin) / thick};
}

}  // namespace

std::vector<RuleDifference> rule_differences(const std::filesystem::path& lmp,
                                             const std::filesystem::path& folder) {
    const auto shown = [&](const Throw& c, RuleDifference d) {
        return shown_by(lmp, folder, c, std::move(d));
    };
    return {
        shown({.name = "lever", .angle_deg = 40.0, .depth = 1e-2, .spin = 1.0},
              {.rule = "lever of the spin in the slip velocity",
               .ours = "R - overlap/2, as for the torque",
               .theirs = "R; R - overlap/2 for the torque",
               .conditions = "40 deg, overlap 1 % of R, with spin"}),
        shown({.name = "slider", .angle_deg = 60.0, .damping = 0.3, .tangential_ratio = 1.0},
              {.rule = "spring of a sliding contact with a tangential dashpot",
               .ours = "spring alone and spring with dashpot each shortened to mu N",
               .theirs = "spring set to (mu N - c v)/k, backwards where c v is larger",
               .conditions = "60 deg, eta at 0.3 of critical, x_gammat 1"}),
        shown({.name = "negative-cap", .angle_deg = 60.0, .adhesion = 0.0, .damping = 0.3},
              {.rule = "friction while the dashpot pulls harder than the spring (no adhesion)",
               .ours = "none: N = max(0, F_e + F_d)",
               .theirs = "N = |F_e + F_d|",
               .conditions = "60 deg, Hertz, eta at 0.3 of critical"}),
        shown({.name = "twisting",
               .angle_deg = 0.0,
               .rolling_friction = 0.0,
               .screw = 1.0,
               .twisting = true},
              {.rule = "twisting spring",
               .ours = "gives up strain as the contact grows, slides along its own torque",
               .theirs = "keeps its strain, slides along the spin",
               .conditions = "head-on, one grain spinning about the normal"}),
        shown({.name = "wall-modulus",
               .angle_deg = 0.0,
               .sliding_friction = 0.0,
               .rolling_friction = 0.0,
               .adhesion = 0.0,
               .wall = true},
              {.rule = "E* of a grain at a wall of its own material",
               .ours = "E/(2 (1 - nu^2)), as between grains",
               .theirs = "E/(2 (1 - nu))",
               .conditions = "head-on, nu 0.3, no adhesion"}),
        shown({.name = "wall-stiffness",
               .angle_deg = 40.0,
               .adhesion = 0.0,
               .wall = true,
               .poisson_ratio = 0.0},
              {.rule = "k_t of a grain at a wall, made from E and nu (NULL)",
               .ours = "8 G* a, as between grains",
               .theirs = "half of it",
               .conditions = "40 deg, nu 0, no adhesion"}),
        shown({.name = "wall-adhesion",
               .angle_deg = 0.0,
               .sliding_friction = 0.0,
               .rolling_friction = 0.0,
               .wall = true,
               .poisson_ratio = 0.0},
              {.rule = "end of an adhesive contact with a wall",
               .ours = "at the gap of the deepest tension, as between grains",
               .theirs = "kept beyond the fold of d(a), where its force is not a number",
               .conditions = "head-on, nu 0, jkr"}),
        lost_with_the_list(lmp, folder),
    };
}

}  // namespace verify
