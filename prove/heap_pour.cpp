// SPDX-License-Identifier: MIT
#include "prove/heap_pour.hpp"

#include "prove/dice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

namespace prove {
namespace {

constexpr double gravity = 9.81, pi = std::numbers::pi;

struct Fed {
    double x, y, radius, due;  // in the room; due in s
};

// Log-normal by number (docs/effects.md): `size_spread` is the standard deviation over the mean.
double diameter_of(const Pour& p, Dice& dice) {
    constexpr double most = 2.5;  // deviations of the logarithm
    double z = dice.normal();
    while (std::abs(z) > most) z = dice.normal();
    const double variance = std::log1p(p.acts.size_spread * p.acts.size_spread);
    return p.grain.diameter * std::exp(std::sqrt(variance) * z - 0.5 * variance);
}

// Evenly over the disc of the feed, each wholly inside it.
std::vector<Fed> feed_of(const Pour& p) {
    Dice dice(p.seed, 0, 11);
    std::vector<Fed> all;
    for (int k = 0; k < p.rig.grains; ++k) {
        const double radius = 0.5 * diameter_of(p, dice);
        const double r = (0.5 * p.rig.feed_diameter - radius) * std::sqrt(dice.uniform());
        const double azimuth = dice.uniform(0.0, 2.0 * pi);
        all.push_back({r * std::cos(azimuth), r * std::sin(azimuth), radius, k / p.rig.feed_rate});
    }
    return all;
}

struct Place {
    double x, y, z;
};

std::vector<Place> base_grains(const Pour& p) {
    const double d = p.grain.diameter, most = 0.5 * p.rig.base_diameter * (1.0 + 1e-12);
    const int n = static_cast<int>(std::ceil(most / d)) + 1;
    std::vector<Place> all;
    for (int i = -n; i < n; ++i)
        for (int j = -n; j < n; ++j) {
            const double x = (i + 0.5) * d, y = (j + 0.5) * d;
            if (std::hypot(x, y) <= most) all.push_back({x, y, -0.5 * d});
        }
    return all;
}

// Where a grain may appear at the most, in the room.
double highest(const Pour& p) { return p.rig.drop_height + 20.0 * p.grain.diameter; }

double mass(const Pour& p) { return p.grain.density * pi / 6.0 * std::pow(p.grain.diameter, 3); }

// Force that tears two nominal grains apart: 3/2 pi w R*, R* = d/4 (Johnson, Kendall & Roberts 1971).
double pull_off(const Pour& p) {
    return 1.5 * pi * p.acts.work_of_adhesion * 0.25 * p.grain.diameter;
}

// A share of the time in which a Rayleigh wave crosses the smallest grain.
double time_step(const Pour& p, const std::vector<Fed>& feed) {
    double radius = 0.5 * p.grain.diameter;
    for (const Fed& g : feed) radius = std::min(radius, g.radius);
    const double nu = p.grain.poisson_ratio;
    const double shear = 0.5 * p.grain.youngs_modulus / (1.0 + nu);
    const double crossing =
        pi * radius * std::sqrt(p.grain.density / shear) / (0.163 * nu + 0.8766);
    return (p.acts.work_of_adhesion > 0.0 ? 0.1 : 0.15) * crossing;
}

// The dashpot's share by LAMMPS' manual (`damping tsuji`), of the restitution that it is told.
double lammps_dashpot(double e) {
    double a = 0.0;
    for (const double c : {4.8218, -18.022, 27.467, -22.348, 11.087, -4.2783, 1.2728})
        a = a * e + c;
    return a;
}

// LAMMPS' own mixing: E* = E/(2 (1 - nu^2)) and 8 G* from the same E and nu; its surface energy is half the work of adhesion.
// Grains that stick resist twisting, too (Marshall 2009). SDS rolling resists mu R* (F_n + 2 F_po) at most; its spring and dashpot are
// stiff enough to count as rigid: full after a roll of mu d/100.
std::string pair_of(const Pour& p) {
    const Powder& g = p.grain;
    const HeapPhysics& a = p.acts;
    const double told = restitution_told(g.restitution);
    std::string text = a.work_of_adhesion > 0.0
                           ? fmt::format("jkr {:.12g} {:.12g} {:.12g} {:.12g}", g.youngs_modulus,
                                         told, g.poisson_ratio, 0.5 * a.work_of_adhesion)
                           : fmt::format("hertz/material {:.12g} {:.12g} {:.12g}", g.youngs_modulus,
                                         told, g.poisson_ratio);
    text += fmt::format(" damping tsuji tangential mindlin_rescale NULL 1.0 {:.12g}",
                        a.sliding_friction);
    if (a.rolling_friction > 0.0) {
        const double k = 100.0 * (mass(p) * gravity + 2.0 * pull_off(p)) / g.diameter;
        text += fmt::format(" rolling sds {:.12g} {:.12g} {:.12g}", k, std::sqrt(k * mass(p)),
                            a.rolling_friction);
    }
    if (a.work_of_adhesion > 0.0) text += " twisting marshall";
    return text;
}

std::string head(const Pour& p, double step, std::size_t glued) {
    const double c = std::cos(p.acts.tilt_angle), s = std::sin(p.acts.tilt_angle);
    return fmt::format(
        R"(# A heap on glued grains: lmp -in deck.in -var folder . Written for LAMMPS of 29 Sep 2021; SI units.
units si
atom_style sphere
boundary f f f
# Sorting in between loses the springs of contacts in this release.
atom_modify sort 0 0.0
newton off
comm_modify vel yes
read_data ${{folder}}/grains.data
# Grains that are still to come stand in a row above, where nothing moves them.
group loose empty
group glued type 2
neighbor {skin:.12g} bin
neigh_modify delay 0 every 1 check yes exclude group glued glued
pair_style granular
pair_coeff * * {pair}
timestep {step:.12g}
fix weight loose gravity {g:.12g} vector {gx:.12g} {gy:.12g} {gz:.12g}
fix motion loose nve/sphere
fix hold glued freeze
compute way loose ke
compute turn loose erotate/sphere
compute size loose property/atom radius
variable top atom 0
compute top loose reduce max v_top
thermo 1000000
thermo_style custom step atoms c_way c_turn c_top
thermo_modify lost ignore
# {n} glued grains, {m} to come.
run 0 post no
)",
        fmt::arg("skin", 0.3 * p.grain.diameter), fmt::arg("pair", pair_of(p)),
        fmt::arg("step", step), fmt::arg("g", gravity),
        fmt::arg("gx", s * std::cos(p.acts.tilt_azimuth)),
        fmt::arg("gy", s * std::sin(p.acts.tilt_azimuth)), fmt::arg("gz", -c), fmt::arg("n", glued),
        fmt::arg("m", p.rig.grains));
}

// How grain `id`, due over (`along`, `across`) with `radius`, finds its height in the room: from the drop height up, the lowest at which it
// is clear of every grain that is there by a thousandth of their reach (docs/pile.md). The feed stands upright over the middle of the
// base, along the lean and across it; the deck's frame is that of the base, which leans down towards the azimuth.
std::string lift(const Pour& p) {
    const double c = std::cos(p.acts.tilt_angle), s = std::sin(p.acts.tilt_angle);
    const double ex = std::cos(p.acts.tilt_azimuth), ey = std::sin(p.acts.tilt_azimuth);
    return fmt::format(R"deck(variable high equal {drop:.12g}+${{radius}}
variable high equal $(v_high:%.12g)
variable down atom x*({ex:.12g})+y*({ey:.12g})
variable height atom z*({c:.12g})-v_down*({s:.12g})
variable level atom (1.001*(c_size+${{radius}}))^2-(v_down*({c:.12g})+z*({s:.12g})-(${{along}}))^2-(y*({ex:.12g})-x*({ey:.12g})-(${{across}}))^2
run ${{due}} upto pre no post no
label look
variable top atom (v_level>0)*((${{high}}-v_height)^2<v_level)*(v_height+1.001*sqrt(abs(v_level)))
run 0 pre no post no
variable blocked equal $(c_top:%.12g)
if "${{blocked}} > 0" then "variable high equal ${{blocked}}" "jump SELF look"
if "${{high}} > {most:.12g}" then "print 'a stream of grains is too dense to be fed'" "quit 1"
variable lean equal ${{along}}*({c:.12g})-${{high}}*({s:.12g})
set atom ${{id}} x $(v_lean*({ex:.12g})-v_across*({ey:.12g}):%.12g) y $(v_lean*({ey:.12g})+v_across*({ex:.12g}):%.12g) z $(v_along*({s:.12g})+v_high*({c:.12g}):%.12g)
group loose id ${{id}}
print "appears ${{high}}"
)deck",
                       fmt::arg("drop", p.rig.drop_height), fmt::arg("most", highest(p)),
                       fmt::arg("c", c), fmt::arg("s", s), fmt::arg("ex", ex), fmt::arg("ey", ey));
}

// At rest: below 1e-6 m g d a grain for sqrt(1000 d/g), looked at every 1000 steps; given up after ten times as long: what still moves then
// are grains held by adhesion that spin in place, and the scanner sees none of it.
std::string rest(const Pour& p, double step) {
    constexpr int look = 1000;
    const double d = p.grain.diameter;
    const double still = std::sqrt(1000.0 * d / gravity) / step;
    return fmt::format(R"deck(
variable energy equal (c_way+c_turn)/(count(loose)+(count(loose)==0))
variable moved string $(step)
variable looks loop {most}
label settle
run {look} pre no post no
variable now equal $(v_energy)
if "${{now}} > {limit:.6g}" then "variable moved string $(step)"
variable calm equal step-${{moved}}
if "${{calm}} >= {still:.0f}" then "jump SELF done"
next looks
jump SELF settle
print "given up"
label done
write_dump loose custom ${{folder}}/heap.dump id x y z radius modify sort id format float %.9g
)deck",
                       fmt::arg("most", static_cast<int>(10.0 * still / look)),
                       fmt::arg("look", look), fmt::arg("limit", 1e-6 * mass(p) * gravity * d),
                       fmt::arg("still", still));
}

}  // namespace

// This release leaves out the root of 2 that two grains' reduced mass asks for (later ones have it): told 0.5, impacts have 0.62. So it
// is told a restitution whose dashpot is that much stronger.
double restitution_told(double e) {
    double low = 0.0, high = 1.0;
    for (int k = 0; k < 50; ++k) {
        const double middle = 0.5 * (low + high);
        (lammps_dashpot(middle) > std::numbers::sqrt2 * lammps_dashpot(e) ? low : high) = middle;
    }
    return low;
}

std::map<std::string, std::string> lammps_files(const Pour& p) {
    const std::vector<Fed> feed = feed_of(p);
    const std::vector<Place> glued = base_grains(p);
    const double d = p.grain.diameter, step = time_step(p, feed);
    double largest = d;
    for (const Fed& g : feed) largest = std::max(largest, 2.0 * g.radius);
    const double shelf = highest(p) + 4.0 * largest, apart = 1.5 * largest;
    const double half =
        0.5 * p.rig.base_diameter + 6.0 * d + highest(p) * std::sin(p.acts.tilt_angle);
    std::string data = fmt::format(
        "a heap on glued grains\n\n{} atoms\n2 atom types\n\n{:.12g} {:.12g} xlo xhi\n{:.12g} "
        "{:.12g} ylo yhi\n{:.12g} {:.12g} zlo zhi\n\nAtoms # sphere\n\n",
        feed.size() + glued.size(), -half, half, -half, half, -4.0 * largest,
        shelf + apart * static_cast<double>(feed.size() + 2));
    std::string text = head(p, step, glued.size());
    const double ex = std::cos(p.acts.tilt_azimuth), ey = std::sin(p.acts.tilt_azimuth);
    std::size_t id = 0;
    for (const Fed& g : feed) {
        ++id;
        data += fmt::format("{} 1 {:.12g} {:.12g} {:.12g} {:.12g} {:.12g}\n", id, 2.0 * g.radius,
                            p.grain.density, 0.0, 0.0, shelf + apart * static_cast<double>(id));
        const double along = g.x * ex + g.y * ey, across = g.y * ex - g.x * ey;
        text += fmt::format(
            "variable id equal {}\nvariable due equal {:.0f}\nvariable along equal {:.12g}\n"
            "variable across equal {:.12g}\nvariable radius equal {:.12g}\n"
            "include ${{folder}}/lift.in\n",
            id, std::ceil(g.due / step), along, across, g.radius);
    }
    for (const Place& g : glued)
        data += fmt::format("{} 2 {:.12g} {:.12g} {:.12g} {:.12g} {:.12g}\n", ++id, d,
                            p.grain.density, g.x, g.y, g.z);
    return {{"deck.in", text + rest(p, step)}, {"lift.in", lift(p)}, {"grains.data", data}};
}

std::vector<Ball> read_heap(const std::string& text) {
    std::istringstream in(text);
    std::string line;
    std::size_t count = 0;
    while (std::getline(in, line)) {
        if (line == "ITEM: NUMBER OF ATOMS") in >> count;
        if (line.starts_with("ITEM: ATOMS")) break;
    }
    if (line != "ITEM: ATOMS id x y z radius")
        throw std::runtime_error("a heap's dump has no line \"ITEM: ATOMS id x y z radius\"");
    std::vector<Ball> all(count);
    for (Ball& b : all) {
        long id = 0;
        in >> id >> b.x >> b.y >> b.z >> b.radius;
    }
    if (!in)
        throw std::runtime_error(fmt::format("a heap's dump ends before its {} grains", count));
    return all;
}

double height_above(const std::vector<Ball>& heap, const Spot& spot) {
    const double x = spot.r * std::cos(spot.azimuth), y = spot.r * std::sin(spot.azimuth);
    double top = 0.0;
    for (const Ball& b : heap) {
        const double square = b.radius * b.radius - std::pow(x - b.x, 2) - std::pow(y - b.y, 2);
        if (square > 0.0) top = std::max(top, b.z + std::sqrt(square));
    }
    return top;
}

}  // namespace prove
