// SPDX-License-Identifier: MIT
#include "engines/lammps_vessels.hpp"

#include "engines/lammps_pile.hpp"
#include "engines/pile_feed.hpp"
#include "rigs/vessels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

namespace engines {
namespace {

using rigs::Column;
using rigs::Drum;
using rigs::FlowSetup;
using rigs::Silo;

// m, higher than any grain.
double top_of(const FlowSetup& s) {
    double top = 0.0;
    for (std::size_t k = 0; k < s.place.size(); ++k)
        top = std::max(top, s.place[k].z + s.radius[k]);
    return top + s.d;
}

std::string wall(const std::string& name, const std::string& group, const std::string& rules,
                 const std::string& region) {
    return fmt::format("region {0} {3}\nfix {0} {1} wall/gran/region granular {2} region {0}\n",
                       name, group, rules, region + " units box");
}

std::string tube(double radius, double top) {
    return fmt::format("cylinder z 0 0 {:.17g} 0 {:.17g} open 1 open 2", radius, top);
}

// === column

std::string fixed_tube(const Column& c, const FlowSetup& s, const std::string& rules) {
    return "group held type 1\n" + wall("tube", "held", rules, tube(c.radius, top_of(s)));
}

std::string lifted_tube(const Column& c, const FlowSetup& s, const std::string& rules) {
    return fmt::format("variable rise equal {:.17g}*dt*v_since\n", c.lift_speed) +
           wall("tube", "loose", rules, tube(c.radius, top_of(s)) + " move NULL NULL v_rise");
}

std::string column_watch(const Column& c, const FlowSetup& s) {
    const std::string below = fmt::format(
        R"deck(variable over_all equal v_rise-c_tip-{:.17g}
if "${{above}} == 0 && ${{over_all}} >= 0" then "variable above string 1"
if "${{above}} == 0" then "variable moved string $(step)" "jump SELF risen"
)deck",
        s.d);
    return (c.lift_speed > 0.0 ? below : "") +
           lammps_calm(whole_checks(s.time_step, s.rest_duration), "\"jump SELF over\"") +
           fmt::format("if \"$(v_since) >= {}\" then \"jump SELF over\"\nlabel risen\n",
                       whole_checks(s.time_step, s.longest));
}

VesselWords words(const Column& c, const FlowSetup& s, const std::string& rules,
                  const DeckOptions&) {
    const bool lifted = c.lift_speed > 0.0;
    return {"z", "* * 1",
            fmt::format("fix floor loose wall/gran granular {} zplane 0.0 NULL\n", rules) +
                (lifted ? lifted_tube(c, s, rules) : fixed_tube(c, s, rules)),
            lifted ? "# Whether the wall is a diameter above all grains.\nvariable above string 0\n"
                   : "group held clear\n",
            column_watch(c, s)};
}

std::string note(const Column&, const FlowSetup&) { return ""; }

// === drum

VesselWords words(const Drum& drum, const FlowSetup& s, const std::string& rules,
                  const DeckOptions&) {
    const std::string turns = " side in rotate v_turn 0 0 0 0 0 1";
    const std::string watch = s.times.empty()
                                  ? fmt::format("if \"$(v_since) >= {}\" then \"jump SELF over\"\n",
                                                whole_checks(s.time_step, rigs::run_time(drum)))
                                  : "";
    return {"y", "* 1 *",
            fmt::format("variable turn equal {:.17g}*dt*v_since\n", drum.speed) +
                wall("mantle", "loose", rules, tube(0.5 * drum.diameter, drum.length) + turns) +
                wall("near", "loose", rules, "plane 0 0 0 0 0 1" + turns) +
                wall("far", "loose", rules,
                     fmt::format("plane 0 0 {:.17g} 0 0 -1", drum.length) + turns),
            "", watch};
}

std::string note(const Drum&, const FlowSetup& s) {
    if (s.walls.rolling_friction == 0.0) return "";
    return "LAMMPS' rolling resistance at a wall counts a grain's own spin, also where it turns "
           "with "
           "the drum: at the mantle, mu_r R times the load too much";
}

// === discharge

std::string sheet(const std::string& x, double y) {
    return fmt::format("block {} {:.17g} {:.17g} 0 0 side out", x, -y, y);
}

std::string slotted_bottom(const Silo& silo, const std::string& rules) {
    const double x = 0.5 * silo.outlet_width, out = 2.0 * silo.width, y = 2.0 * silo.depth;
    return wall("left", "loose", rules, sheet(fmt::format("{:.17g} {:.17g}", -out, -x), y)) +
           wall("right", "loose", rules, sheet(fmt::format("{:.17g} {:.17g}", x, out), y)) +
           wall("lid", "shut", rules, sheet(fmt::format("{:.17g} {:.17g}", -x, x), y));
}

std::string holed_bottom(const Silo& silo, double d, const std::string& rules) {
    const double r = 0.5 * silo.outlet_width, out = 2.0 * std::hypot(silo.width, silo.depth);
    const double thick = 1e-3 * d;
    return wall("bottom", "loose", rules,
                fmt::format("cone z 0 0 {:.17g} {:.17g} {:.17g} 0 side out open 1 open 2", r, out,
                            -thick)) +
           wall("lid", "shut", rules,
                fmt::format("cylinder z 0 0 {:.17g} {:.17g} 0 side out", r, -thick));
}

std::string sides(const Silo& silo, const FlowSetup& s, const std::string& rules) {
    if (silo.round)
        return wall("sides", "loose", rules, tube(0.5 * silo.width, top_of(s)) + " side in");
    return fmt::format(R"(fix sides_x loose wall/gran granular {0} xplane {1:.17g} {2:.17g}
fix sides_y loose wall/gran granular {0} yplane {3:.17g} {4:.17g}
)",
                       rules, -0.5 * silo.width, 0.5 * silo.width, -0.5 * silo.depth,
                       0.5 * silo.depth);
}

// Grains that have left are parked where they meet nobody; the way there makes the lists anew.
std::string silo_watch(const FlowSetup& s) {
    return fmt::format(R"deck(variable inside string $(c_within)
if "${{inside}} == ${{inside_before}}" then "jump SELF nobody"
variable out_at string $(step)
variable inside_before string ${{inside}}
group out variable sunk
group loose subtract loose out
group parked union parked out
set group out z v_deeper
group out clear
label nobody
if "${{inside}} == 0" then "jump SELF over"
variable waited equal step-${{out_at}}
if "${{waited}} >= {}" then "jump SELF over"
)deck",
                       whole_checks(s.time_step, s.rest_duration));
}

void refuse_outlet(const Silo& silo, const FlowSetup& s, const DeckOptions& o) {
    if (!silo.round_outlet && (silo.round || silo.outlet_depth < silo.depth))
        refuse(o, "lammps", "has no region for a slot with ends, nor for one in a round silo",
               "take outlet_diameter, or a slot as long as a box silo, or dem_min");
    // A rim curves by -2 R in LAMMPS: R* = r R/(R - r/2).
    const double largest = *std::max_element(s.radius.begin(), s.radius.end());
    if (silo.outlet_width <= 2.0 * largest)
        refuse(o, "lammps", "is told of no outlet that is narrower than a grain",
               "take a wider one, or dem_min");
}

VesselWords words(const Silo& silo, const FlowSetup& s, const std::string& rules,
                  const DeckOptions& o) {
    refuse_outlet(silo, s, o);
    return {"z", "* * 1",
            sides(silo, s, rules) + "# A lid lies in the outlet until t = 0.\ngroup shut type 1\n" +
                (silo.round_outlet ? holed_bottom(silo, s.d, rules) : slotted_bottom(silo, rules)),
            fmt::format(R"(group shut clear
variable inside_before string $(c_within)
variable sunk atom gmask(loose)*(z<{:.17g})
variable deeper atom z-{:.17g}
)",
                        gone_below(s), 5.0 * s.d),
            silo_watch(s)};
}

std::string note(const Silo&, const FlowSetup&) { return ""; }

}  // namespace

VesselWords vessel_words(const FlowSetup& s, const std::string& rules, const DeckOptions& o) {
    return std::visit([&](const auto& v) { return words(v, s, rules, o); }, s.vessel);
}

std::string vessel_note(const FlowSetup& s) {
    return std::visit([&](const auto& v) { return note(v, s); }, s.vessel);
}

double gone_below(const FlowSetup& s) {
    return -*std::max_element(s.radius.begin(), s.radius.end());
}

}  // namespace engines
