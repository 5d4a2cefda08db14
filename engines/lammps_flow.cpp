// SPDX-License-Identifier: MIT
#include "engines/lammps_flow.hpp"

#include "engines/lammps_files.hpp"
#include "engines/lammps_pile.hpp"
#include "engines/lammps_rules.hpp"
#include "engines/lammps_vessels.hpp"
#include "engines/pile_feed.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace engines {
namespace {

using rigs::FlowSetup;

std::string down(const VesselWords& v) { return v.up == "y" ? "0 -1 0" : "0 0 -1"; }

std::vector<dem_min::Grain> grains_of(const FlowSetup& s) {
    std::vector<dem_min::Grain> grains;
    for (std::size_t k = 0; k < s.place.size(); ++k)
        grains.push_back({s.place[k], {}, {}, s.radius[k], s.density});
    return grains;
}

// Of the grains as they begin; it grows with them.
Box box_of(const FlowSetup& s) {
    Box box{s.place.front(), s.place.front()};
    for (std::size_t k = 0; k < s.place.size(); ++k) {
        const auto widen = [&](double& low, double& high, double at) {
            low = std::min(low, at - 2.0 * s.radius[k]);
            high = std::max(high, at + 2.0 * s.radius[k]);
        };
        widen(box.low.x, box.high.x, s.place[k].x);
        widen(box.low.y, box.high.y, s.place[k].y);
        widen(box.low.z, box.high.z, s.place[k].z);
    }
    return box;
}

std::string head(const FlowSetup& s, const DeckOptions& o, const VesselWords& v) {
    return fmt::format(
        R"(# A rig of similitude in LAMMPS: lmp -in deck.in, or mpirun -np N lmp -in deck.in. SI units; up is {up}.
{release}# One run is set up, the first: with every further one the dashpot of a wall changes in the release of 2021.
units si
atom_style sphere
# The box grows with the grains: none is lost.
boundary m m m
# Sorting at the start of a run loses springs.
atom_modify sort 0 0.0
newton off
comm_modify vel yes
processors {processors}
read_data grains.data
group loose type 1
# Grains that are struck off or have left: nothing moves them and they touch nothing.
group parked empty
neighbor {skin:.17g} bin
neigh_modify delay 0 every 1 check yes exclude group parked all
pair_style granular
pair_coeff * * {pair}
timestep {dt:.17g}
fix fall loose gravity {g:.17g} vector {down}
fix motion loose nve/sphere
variable since equal 0
{walls})",
        fmt::arg("release", release_line(o)), fmt::arg("up", v.up),
        fmt::arg("processors", v.processors), fmt::arg("skin", 0.4 * s.d),
        fmt::arg("pair", granular_arguments(s.grains, o, nominal_pair(s.d, s.density))),
        fmt::arg("dt", s.time_step), fmt::arg("g", s.gravity), fmt::arg("down", down(v)),
        fmt::arg("walls", v.walls));
}

std::string questions(const FlowSetup& s, const VesselWords& v) {
    const double unit = 2.0 * nominal_pair(s.d, s.density).m_star * s.gravity * s.d;
    return fmt::format(R"(
compute kinetic loose ke
compute radius all property/atom radius
variable restless equal c_kinetic/((count(loose)+(count(loose)==0))*{unit:.17g})
variable tip atom {up}+c_radius
compute tip loose reduce max v_tip
variable within atom z>={gone:.17g}
compute within loose reduce sum v_within
thermo 2000
variable present equal count(loose)
thermo_style custom step v_present c_kinetic c_tip c_within
thermo_modify flush yes
)",
                       fmt::arg("unit", unit), fmt::arg("up", v.up),
                       fmt::arg("gone", gone_below(s)));
}

std::string strike_off(const FlowSetup& s, const VesselWords& v) {
    if (!(s.filling.level > 0.0)) return "";
    return fmt::format(R"(if "${{levelled}} == 1" then "jump SELF release"
# What stands above the level is parked, a d higher: the way there makes the lists anew.
variable high atom {up}>{level:.17g}
variable lifted atom {up}+{d:.17g}
group spilt variable high
group loose subtract loose spilt
group parked union parked spilt
set group spilt {up} v_lifted
variable levelled string 1
variable moved string $(step)
jump SELF settle
)",
                       fmt::arg("up", v.up), fmt::arg("level", s.filling.level),
                       fmt::arg("d", s.d));
}

std::string bed(const FlowSetup& s, const VesselWords& v) {
    const std::int64_t still = whole_checks(s.time_step, s.rest_duration);
    return fmt::format(R"deck(
# The bed: at rest below 1e-6 m g d a grain without a break for {still} steps; `moved` is the last look that found more.
run 0 post no
variable levelled string 0
variable moved string 0
label settle
run {check} pre no post no
{calm}if "$(step) < {longest}" then "jump SELF settle"
print "similitude: given up at step $(step)"
jump SELF results
label still
{strike_off}label release
)deck",
                       fmt::arg("still", still), fmt::arg("check", rest_check_interval),
                       fmt::arg("calm", lammps_calm(still, "\"jump SELF still\"")),
                       fmt::arg("longest", whole_checks(s.time_step, s.longest)),
                       fmt::arg("strike_off", strike_off(s, v)));
}

constexpr const char* seen =
    "write_dump loose custom looks.dump id type x y z vx vy vz omegax omegay omegaz radius "
    "modify append yes sort id format float %.17g\n";

// When the next look is due, and what makes the one after it the next.
struct Looks {
    std::string first, next, all_taken;
};
Looks looks_of(const FlowSetup& s) {
    if (s.times.empty())
        return {fmt::format("variable due equal ${{t0}}+round(v_taken*{:.17g}/{:.17g})\n", s.every,
                            s.time_step),
                "", ""};
    const std::size_t count = s.times.size();
    return {"variable after file look-steps.txt\nvariable due equal ${t0}+v_after\n",
            fmt::format("if \"${{taken}} < {}\" then \"next after\" else \"variable due equal "
                        "1e15\"\n",
                        count),
            fmt::format("if \"${{taken}} >= {}\" then \"jump SELF over\"\n", count)};
}

std::string flow(const FlowSetup& s, const VesselWords& v) {
    const Looks looks = looks_of(s);
    return fmt::format(
        R"deck(# t = 0.
variable t0 string $(step)
print "similitude: released at step ${{t0}}"
{seen}variable since equal step-${{t0}}
variable moved string $(step-{check})
variable out_at string ${{t0}}
variable taken string 0
{first}{let_go}
# Looks at the steps that the rig looks at, and each {check} steps: is it over?
label flow
if "$(step) < $(v_due)" then "jump SELF watch"
{seen}variable taken string $(v_taken+1)
{next}jump SELF flow
label watch
if "$(step%{check}) != 0" then "jump SELF on"
{watch}{all_taken}label on
variable until string $({check}*floor(step/{check})+{check})
if "$(v_due) < ${{until}}" then "variable until string $(v_due)"
run ${{until}} upto pre no post no
jump SELF flow
label over
print "similitude: over at step $(step), still since $(v_moved+{check}), last out ${{out_at}}"
label results
{seen}write_data final.data nocoeff
)deck",
        fmt::arg("seen", seen), fmt::arg("check", rest_check_interval),
        fmt::arg("first", looks.first), fmt::arg("next", looks.next),
        fmt::arg("all_taken", looks.all_taken), fmt::arg("let_go", v.let_go),
        fmt::arg("watch", v.watch));
}

std::string look_steps(const FlowSetup& s) {
    std::string text;
    for (std::size_t k = 0; k < s.times.size(); ++k)
        text += fmt::format("{}\n", rigs::steps_to_look(s, k));
    return text;
}

}  // namespace

Deck lammps_flow(const FlowSetup& s, const DeckOptions& options) {
    refuse_contacts(s.grains, s.walls, options, "leave wall_adhesion out, or take dem_min");
    const std::string rules = granular_arguments(s.walls, options, nominal_pair(s.d, s.density));
    const VesselWords v = vessel_words(s, rules, options);
    Deck result{"deck.in", head(s, options, v) + questions(s, v) + bed(s, v) + flow(s, v)};
    result.files.emplace_back("grains.data", lammps_data(grains_of(s), box_of(s), 1));
    if (!s.times.empty()) result.files.emplace_back("look-steps.txt", look_steps(s));
    return result;
}

}  // namespace engines
