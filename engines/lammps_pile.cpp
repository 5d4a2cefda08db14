// SPDX-License-Identifier: MIT
#include "engines/lammps_pile.hpp"

#include "engines/lammps_rules.hpp"
#include "engines/lammps_surroundings.hpp"
#include "engines/pile_feed.hpp"
#include "engines/process.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace engines {
namespace {

using dem_min::Grain;
using rigs::PileSetup;

bool is_flat(const PileSetup& s) { return s.conditions.base == rigs::Base::flat; }

NominalPair nominal(const PileSetup& s) { return nominal_pair(s.d, s.density); }

void refuse_what_lammps_has_not(const PileSetup& s, const DeckOptions& o) {
    if (s.conditions.base == rigs::Base::flat_with_rim)
        refuse(o, "lammps", "is told of no rim", "take flat or glued_grains for the base");
    std::optional<std::string> smooth;
    if (is_flat(s)) smooth = "take glued_grains for the base, or no wall_adhesion";
    refuse_contacts(s.grains, s.walls, o, smooth);
    refuse_rig_of_our_own(s, o, "lammps");
}

// A data file whose charges are the upward velocities: with several ranks, LAMMPS crashes on a section Velocities that is added to
// grains that have ghosts.
std::string added_data(const std::vector<Grain>& grains, const Box& box) {
    std::string text = fmt::format(
        "written by similitude\n\n{} atoms\n2 atom types\n\n{:.17g} {:.17g} xlo xhi\n{:.17g} "
        "{:.17g} ylo yhi\n{:.17g} {:.17g} zlo zhi\n\nAtoms # hybrid\n\n",
        grains.size(), box.low.x, box.high.x, box.low.y, box.high.y, box.low.z, box.high.z);
    for (std::size_t k = 0; k < grains.size(); ++k) {
        const Grain& g = grains[k];
        text += fmt::format("{} {} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", k + 1,
                            g.fixed ? 2 : 1, g.position.x, g.position.y, g.position.z,
                            2.0 * g.radius, g.density, g.velocity.z);
    }
    return text;
}

constexpr const char* glued_base = R"(group loose type 1
group glued type 2
read_data base.data add append group glued
neigh_modify delay 0 every 1 check yes exclude group glued glued)";
constexpr const char* frozen =
    R"(# Glued grains: frozen, and infinitely heavy in the reduced mass of a contact.
fix hold glued freeze)";

// Over a wall nothing may be read between two runs: a run that is set up anew (pre yes) puts the number of a wall's dashpot through the
// polynomial of `tsuji` again. So all grains are there from the start, parked, and a batch is fed by making it loose.
constexpr const char* parked_grains =
    R"(# Grains that are still to be fed: nothing moves them and they touch nothing.
read_data grains.data add append
group parked type 1
group loose empty
neigh_modify delay 0 every 1 check yes exclude group parked all)";

// A disc of a thousandth of a d: its edge is where a grain falls off.
std::string plate(const PileSetup& s, const DeckOptions& o) {
    return fmt::format(R"(region base cylinder z 0 0 {:.17g} {:.17g} 0 side out units box
fix plate loose wall/gran/region granular {} region base)",
                       0.5 * s.conditions.base_diameter, -1e-3 * s.d,
                       granular_arguments(s.walls, o, nominal(s)));
}

std::string head(const PileSetup& s, const DeckOptions& o) {
    const Box box = pile_box(s);
    // The margin must hold a neck that is stretched: LAMMPS ends it where the list is made anew and has lost the pair.
    return fmt::format(
        R"(# The rig pile of similitude in LAMMPS: lmp -in deck.in, or mpirun -np N lmp -in deck.in.
{release}# Loose grains have type 1, glued ones type 2. SI units; the base's top is z = 0.
units si
# The charge of a grain is the velocity at which it is fed, m/s, and nothing else.
atom_style hybrid sphere charge
boundary f f f
# Sorting at the start of a run loses the springs of half of the contacts (measured in this release).
atom_modify sort 0 0.0
newton off
comm_modify vel yes
processors * * 1
region all block {xl:.17g} {xh:.17g} {yl:.17g} {yh:.17g} {zl:.17g} {zh:.17g} units box
create_box 2 all
{grains}
neighbor {skin:.17g} bin
pair_style granular
pair_coeff * * {pair}
# The step before all fixes: some take it when they are made.
timestep {dt:.17g}
{afar}fix motion loose nve/sphere
{base}
)",
        fmt::arg("xl", box.low.x), fmt::arg("xh", box.high.x), fmt::arg("yl", box.low.y),
        fmt::arg("yh", box.high.y), fmt::arg("zl", box.low.z), fmt::arg("zh", box.high.z),
        fmt::arg("release", release_line(o)), fmt::arg("skin", 0.4 * s.d),
        fmt::arg("pair", granular_arguments(s.grains, o, nominal(s))), fmt::arg("dt", s.time_step),
        fmt::arg("afar", lammps_forces_from_afar(s)),
        fmt::arg("grains", is_flat(s) ? parked_grains : glued_base),
        fmt::arg("base", is_flat(s) ? plate(s, o) : frozen));
}

// How far the next batch is shifted up.
std::string shift(const PileSetup& s) {
    return fmt::format(R"(variable heap_up equal c_top[1]-{mouth:.17g}
variable any_up equal c_top[2]-{mouth:.17g}
if "${{any_up}} < ${{up}}" then "variable up string ${{any_up}}"
if "${{heap_up}} > ${{up}}" then "variable up string ${{heap_up}}"
if "${{up}} < 0" then "variable up string 0")",
                       fmt::arg("mouth", s.conditions.drop_height));
}

// `lift`: of the parked grains, so large that a batch which comes down makes the lists anew.
std::string parked_feed_loop(const PileSetup& s, std::size_t batches, double lift) {
    return fmt::format(R"(
# The feed: batch k, the ids of the k-th line of feed-ids.txt, comes loose at the k-th step of feed-steps.txt, shifted up where the
# heap has grown to within 2 d of it, and down again only when it meets none of those fed before. One run is set up, the first.
variable up string 0
variable fall atom q
variable batch loop {n}
variable due file feed-steps.txt
variable ids file feed-ids.txt
run 0 post no
label feed
run ${{due}} upto pre no post no
{shift}
group fresh id ${{ids}}
group loose union loose fresh
group parked subtract parked fresh
{unpark}group fresh clear
if "${{batch}} < {n}" then "next due" "next ids"
next batch
jump SELF feed
)",
                       fmt::arg("n", batches), fmt::arg("unpark", lammps_unparking(s, lift)),
                       fmt::arg("shift", shift(s)));
}

std::string rest_loop(const PileSetup& s) {
    return fmt::format(R"deck(
# At rest: below 1e-6 m g d a grain without a break for {still} steps.
label settle
fix calm all halt {check} v_restless < {limit} error continue message no
run {longest} upto post no
unfix calm
if "$(step) >= {longest}" then "jump SELF given_up"
variable then equal step+{still}
variable until string ${{then}}
fix stir all halt {check} v_restless >= {limit} error continue message no
run ${{until}} upto post no
unfix stir
if "$(step) < ${{until}}" then "jump SELF settle"
print "similitude: at rest at step $(step)"
jump SELF results
label given_up
print "similitude: given up at step $(step)"
label results
# The computes of the dump must be of this step.
run 0 post no
)deck",
                       fmt::arg("check", rest_check_interval), fmt::arg("limit", at_rest_below),
                       fmt::arg("longest", whole_checks(s, s.longest)),
                       fmt::arg("still", whole_checks(s, s.rest_duration)));
}

// The same without `fix halt`, which wants a run that is set up anew.
std::string rest_loop_of_one_run(const PileSetup& s) {
    return fmt::format(R"deck(
# At rest: below 1e-6 m g d a grain without a break for {still} steps; `moved` is the last look that found more.
variable moved string $(step)
label settle
run {check} pre no post no
{calm}if "$(step) < {longest}" then "jump SELF settle"
print "similitude: given up at step $(step)"
label results
run 0 pre no post no
)deck",
                       fmt::arg("check", rest_check_interval),
                       fmt::arg("longest", whole_checks(s, s.longest)),
                       fmt::arg("still", whole_checks(s, s.rest_duration)),
                       fmt::arg("calm", lammps_calm(whole_checks(s, s.rest_duration),
                                                    "\"print 'similitude: at rest at step "
                                                    "$(step)'\" \"jump SELF results\"")));
}

constexpr const char* results =
    R"deck(write_dump all custom final.dump id type x y z vx vy vz omegax omegay omegaz radius c_touching modify sort id format float %.17g
# A data file hands the heap over: read_restart of a jkr run crashes in this release.
write_data final.data nocoeff
)deck";

Deck over_a_plate(const PileSetup& s, const DeckOptions& o, const std::vector<FeedBatch>& batches,
                  const std::vector<double>& z, const std::string& steps) {
    const double lift = s.d;
    std::vector<Grain> all;
    std::string ids;
    for (const FeedBatch& batch : batches) {
        for (const Grain& g : batch_grains(s, batch, z, lift)) all.push_back(g);
        ids += fmt::format("{}:{}\n", batch.first + 1, batch.last + 1);
    }
    return {"deck.in",
            head(s, o) + pile_questions(s, "count(loose)") +
                parked_feed_loop(s, batches.size(), lift) + rest_loop_of_one_run(s) + results,
            {{"grains.data", added_data(all, pile_box(s))},
             {"feed-ids.txt", ids},
             {"feed-steps.txt", steps}}};
}

}  // namespace

std::string lammps_calm(std::int64_t still, const std::string& then) {
    return fmt::format(R"deck(variable restless_now equal v_restless
if "${{restless_now}} >= {limit}" then "variable moved string $(step)"
variable calm equal step-${{moved}}-{check}
if "${{calm}} >= {still}" then {then}
)deck",
                       fmt::arg("limit", at_rest_below), fmt::arg("check", rest_check_interval),
                       fmt::arg("still", still), fmt::arg("then", then));
}

std::string pile_questions(const PileSetup& s, const std::string& present) {
    return fmt::format(R"(
compute kinetic loose ke
compute radius all property/atom radius
compute touching all contact/atom
variable restless equal c_kinetic/((count(loose)+(count(loose)==0))*{unit:.17g})
# Heap: slow grains that touch two others. Two that touch in flight have one contact each.
variable heap atom (c_touching>1)*((vx*vx+vy*vy+vz*vz)<{slow:.17g})*({height}+c_radius+{two_d:.17g})
variable any atom {height}+c_radius+{room:.17g}
compute top loose reduce max v_heap v_any
# Of a batch that has just been read: whether one of it lies within another grain and is pushed aside. Contacts cannot be asked: their
# list is not made anew at a step at which it was made before.
group fresh subtract all all
variable pushed atom {pushed}
compute within fresh reduce max v_pushed
variable higher atom z+v_pushed*{step:.17g}*random(0.5,1.5,15485863)
thermo 2000
variable present equal {present}
thermo_style custom step v_present c_kinetic c_top[1] c_top[2] c_within
# What falls below the base or flies off is gone.
thermo_modify lost ignore flush yes
)",
                       fmt::arg("unit", energy_unit(s)), fmt::arg("slow", 0.25 * s.gravity * s.d),
                       fmt::arg("two_d", 2.0 * s.d), fmt::arg("room", 0.6 * s.d),
                       fmt::arg("step", 0.1 * s.d), fmt::arg("present", present),
                       fmt::arg("height", lammps_height(s)), fmt::arg("pushed", lammps_pushed(s)));
}

std::string pile_feed_loop(const PileSetup& s, std::size_t batches, const std::string& read) {
    return fmt::format(R"(
# The feed: batch k is read at the k-th step of feed-steps.txt, shifted up where the heap has grown to within 2 d of it,
# and down again only when it meets none of those read before. A grain that would appear within another, as within one that bounced up
# to here, goes up until it is clear.
variable up string 0
variable batch loop {n}
variable due file feed-steps.txt
label feed
run ${{due}} upto post no
{shift}
{read}label within
run 0 post no
variable within_now equal c_within
if "${{within_now}} <= 0" then "jump SELF clear"
set group fresh z v_higher
jump SELF within
label clear
if "${{batch}} < {n}" then "next due"
next batch
jump SELF feed
)",
                       fmt::arg("n", batches), fmt::arg("shift", shift(s)), fmt::arg("read", read));
}

Deck lammps_pile(const PileSetup& s, const DeckOptions& options) {
    refuse_what_lammps_has_not(s, options);
    const std::vector<FeedBatch> batches = feed_batches(s);
    const std::vector<double> z = feed_heights(s, batches);
    std::string steps;
    for (const FeedBatch& batch : batches) steps += fmt::format("{}\n", batch.step);
    if (is_flat(s)) return over_a_plate(s, options, batches, z, steps);
    Deck result{"deck.in",
                head(s, options) + pile_questions(s, "count(all)") + "\nvariable fall atom q\n" +
                    pile_feed_loop(s, batches.size(), lammps_reading(s)) + rest_loop(s) + results};
    result.files.emplace_back("base.data", added_data(glued_grains(s), pile_box(s)));
    for (std::size_t k = 0; k < batches.size(); ++k)
        result.files.emplace_back(fmt::format("feed/{}.data", k + 1),
                                  added_data(batch_grains(s, batches[k], z), pile_box(s)));
    result.files.emplace_back("feed-steps.txt", steps);
    return result;
}

std::vector<std::string> lammps_like_deck_command(const std::string& program, int ranks,
                                                  const std::string& log) {
    std::vector<std::string> argv = ranks > 1 ? mpirun(ranks) : std::vector<std::string>{};
    for (const std::string& word :
         {program, std::string("-in"), std::string("deck.in"), std::string("-log"), log})
        argv.push_back(word);
    return argv;
}

}  // namespace engines
