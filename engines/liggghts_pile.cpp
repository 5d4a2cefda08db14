// SPDX-License-Identifier: MIT
#include "engines/lammps_pile.hpp"
#include "engines/liggghts_decks.hpp"
#include "engines/pile_feed.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

namespace engines {
namespace {

using dem_min::Grain;
using rigs::PileSetup;

constexpr int rings_of_a_disc = 16;  // 96 sides: the edge lies within 6e-4 of the radius

// LIGGGHTS starts only where there is a grain of type 1: the base's, where there is one.
int loose_type(const PileSetup& s) { return s.conditions.base == rigs::Base::flat ? 1 : 2; }

// Of one batch. A group of this release cannot be cleared, but what is taken from itself is empty.
std::string reading(const PileSetup& s, std::size_t batches) {
    return fmt::format(R"(read_data feed/${{batch}}.data add
group fresh subtract fresh fresh
group fresh id ${{ids}}
displace_atoms fresh move 0 0 ${{up}} units box
group loose type {}
if "${{batch}} < {}" then "next ids"
)",
                       loose_type(s), batches);
}

void refuse_what_liggghts_has_not(const PileSetup& s, const DeckOptions& o) {
    if (!o.nearest && (s.grains.work_of_adhesion > 0.0 || s.walls.work_of_adhesion > 0.0))
        refuse(o, "liggghts",
               "has no JKR: sjkr pulls by an energy density times the area of overlap, not across "
               "a gap",
               "say --contact nearest for sjkr of the same pull-off force, or leave the option "
               "out: dem_min runs it");
    if (s.grains.as_lammps && s.grains.rolling_friction > 0.0)
        refuse(o, "liggghts", "has no SDS rolling (--contact lammps)",
               "leave --contact out: it has the EPSD rolling of our own");
    if (s.conditions.base == rigs::Base::flat_with_rim)
        refuse(o, "liggghts", "is told of no rim", "take flat or glued_grains for the base");
    refuse_rig_of_our_own(s, o, "liggghts");
    refuse_surroundings(s, o, "liggghts");
    refuse_liggghts_restitution(s.grains.restitution, o);
    if (s.conditions.base == rigs::Base::flat) refuse_liggghts_restitution(s.walls.restitution, o);
}

bool has_disc(const PileSetup& s) { return s.conditions.base == rigs::Base::flat; }

std::string base_of(const PileSetup& s, const LiggghtsRules& rules) {
    if (!has_disc(s))
        return R"(read_data base.data add
group glued type 1
# Glued grains: frozen, and infinitely heavy in the reduced mass of a contact.
fix hold glued freeze
neigh_modify exclude group glued glued
)";
    return fmt::format(R"(# No grain is glued.
group glued type 3
fix disc all mesh/surface file base.stl type 3
fix base all wall/gran {} mesh n_meshes 1 meshes disc
)",
                       rules.model);
}

std::string head(const PileSetup& s, const LiggghtsRules& rules) {
    const Box box = pile_box(s);
    return fmt::format(
        R"(# The rig pile of similitude in LIGGGHTS-PUBLIC 3.8.0: liggghts -in deck.in, or mpirun -np N liggghts -in deck.in.
# Glued grains have type 1 and loose ones type 2, or type 1 on a flat base of type 3. SI units; the base's top is z = 0.
{opening}processors * * 1
region all block {xl:.17g} {xh:.17g} {yl:.17g} {yh:.17g} {zl:.17g} {zh:.17g} units box
create_box 3 all
{model}neigh_modify delay 0 every 1 check yes
group loose type {loose}
{base}fix fall loose gravity {g:.17g} vector 0 0 -1
fix motion loose nve/sphere
)",
        fmt::arg("opening", liggghts_opening(rules)), fmt::arg("xl", box.low.x),
        fmt::arg("xh", box.high.x), fmt::arg("yl", box.low.y), fmt::arg("yh", box.high.y),
        fmt::arg("zl", box.low.z), fmt::arg("zh", box.high.z),
        fmt::arg("model", liggghts_model(rules, 0.4 * s.d, s.time_step)),
        fmt::arg("base", base_of(s, rules)), fmt::arg("loose", loose_type(s)),
        fmt::arg("g", s.gravity));
}

// LIGGGHTS has no `fix halt`: it is asked after each run, and each goes on from the last as it is (`pre no`).
std::string rest_loop(const PileSetup& s, std::int64_t last_batch) {
    std::string format = "%d %d";
    for (int k = 0; k < 10; ++k) format += " %.17g";
    const auto first =
        (last_batch + rest_check_interval) / rest_check_interval * rest_check_interval;
    return fmt::format(
        R"deck(
# At rest: below 1e-6 m g d a grain without a break for {still} steps.
variable now equal step
variable calm string -1
run {first} upto post no
label look
if "${{restless}} >= {limit}" then "variable calm string -1"
if "${{restless}} < {limit} && ${{calm}} < 0" then "variable calm string ${{now}}"
variable still equal step-${{calm}}
if "${{calm}} >= 0 && ${{still}} >= {still}" then "jump SELF at_rest"
if "${{now}} >= {longest}" then "jump SELF given_up"
run {check} pre no post no
jump SELF look
label at_rest
print "similitude: at rest at step ${{now}}"
jump SELF results
label given_up
print "similitude: given up at step ${{now}}"
label results
variable glued atom gmask(glued)
dump last all custom 1 final.dump id type x y z vx vy vz omegax omegay omegaz radius c_touching v_glued
dump_modify last sort id format "{format} %g %g"
run 0 post no
)deck",
        fmt::arg("still", whole_checks(s, s.rest_duration)), fmt::arg("first", first),
        fmt::arg("limit", at_rest_below), fmt::arg("longest", whole_checks(s, s.longest)),
        fmt::arg("check", rest_check_interval), fmt::arg("format", format));
}

}  // namespace

std::string liggghts_data(const std::vector<Grain>& grains, const Box& box, std::size_t first_id,
                          int type) {
    std::string atoms, velocities;
    for (std::size_t k = 0; k < grains.size(); ++k) {
        const Grain& g = grains[k];
        atoms += fmt::format("{} {} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", first_id + k, type,
                             2.0 * g.radius, g.density, g.position.x, g.position.y, g.position.z);
        velocities +=
            fmt::format("{} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", first_id + k,
                        g.velocity.x, g.velocity.y, g.velocity.z, g.spin.x, g.spin.y, g.spin.z);
    }
    return fmt::format(
        "written by similitude\n\n{} atoms\n3 atom types\n\n{:.17g} {:.17g} xlo xhi\n{:.17g} "
        "{:.17g} ylo yhi\n{:.17g} {:.17g} zlo zhi\n\nAtoms\n\n{}\nVelocities\n\n{}",
        grains.size(), box.low.x, box.high.x, box.low.y, box.high.y, box.low.z, box.high.z, atoms,
        velocities);
}

// Rings of triangles of about one size: needles that meet at the centre are beyond what LIGGGHTS takes of a mesh.
std::string disc_stl(double radius) {
    const auto corner = [&](int ring, int k) {
        const double r = radius * ring / rings_of_a_disc;
        const double angle = ring == 0 ? 0.0 : 2.0 * std::numbers::pi * k / (6.0 * ring);
        return std::array{r * std::cos(angle), r * std::sin(angle)};
    };
    std::string text = "solid disc\n";
    const auto triangle = [&](std::array<double, 2> a, std::array<double, 2> b,
                              std::array<double, 2> c) {
        text += "facet normal 0 0 1\nouter loop\n";
        for (const auto& p : {a, b, c})
            text += fmt::format("vertex {:.17g} {:.17g} 0\n", p[0], p[1]);
        text += "endloop\nendfacet\n";
    };
    for (int ring = 1; ring <= rings_of_a_disc; ++ring)
        for (int sextant = 0; sextant < 6; ++sextant)
            for (int k = 0; k < ring; ++k) {
                const int out = sextant * ring + k, in = sextant * (ring - 1) + k;
                triangle(corner(ring, out), corner(ring, out + 1), corner(ring - 1, in));
                if (k + 1 < ring)
                    triangle(corner(ring - 1, in), corner(ring, out + 1), corner(ring - 1, in + 1));
            }
    return text + "endsolid disc\n";
}

Deck liggghts_pile(const PileSetup& s, const DeckOptions& options) {
    refuse_what_liggghts_has_not(s, options);
    const LiggghtsRules rules = liggghts_rules(s.grains, has_disc(s) ? s.walls : s.grains, s.d);
    const std::vector<FeedBatch> batches = feed_batches(s);
    const std::vector<double> z = feed_heights(s, batches);
    Deck result{"deck.in", head(s, rules) + pile_questions(s, "count(all)") +
                               "\nvariable ids file feed-ids.txt\n" +
                               pile_feed_loop(s, batches.size(), reading(s, batches.size())) +
                               rest_loop(s, batches.back().step)};
    const std::vector<Grain> glued = glued_grains(s);
    if (has_disc(s))
        result.files.emplace_back("base.stl", disc_stl(0.5 * s.conditions.base_diameter));
    else
        result.files.emplace_back("base.data", liggghts_data(glued, pile_box(s), 1, 1));
    std::string steps, ids;
    for (std::size_t k = 0; k < batches.size(); ++k) {
        const FeedBatch& b = batches[k];
        const std::size_t first = 1 + glued.size() + b.first;
        steps += fmt::format("{}\n", b.step);
        ids += fmt::format("{}:{}\n", first, first + b.last - b.first);
        result.files.emplace_back(
            fmt::format("feed/{}.data", k + 1),
            liggghts_data(batch_grains(s, b, z), pile_box(s), first, loose_type(s)));
    }
    result.files.emplace_back("feed-steps.txt", steps);
    result.files.emplace_back("feed-ids.txt", ids);
    return result;
}

std::string liggghts_release(const std::string& output) {
    const std::string start = "LIGGGHTS (Version ";
    const std::size_t begin = output.find(start);
    if (begin == std::string::npos) return "unknown";
    const std::size_t at = begin + start.size();
    return output.substr(at, output.find(',', at) - at);
}

}  // namespace engines
