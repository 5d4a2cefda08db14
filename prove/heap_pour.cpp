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
    double x, y, z, radius, due;  // z of the centre where it appears at rest, due in s
};

// Log-normal by number (docs/effects.md): `size_spread` is the standard deviation over the mean.
double diameter_of(const Pour& p, Dice& dice) {
    constexpr double most = 2.5;  // deviations of the logarithm
    double z = dice.normal();
    while (std::abs(z) > most) z = dice.normal();
    const double variance = std::log1p(p.acts.size_spread * p.acts.size_spread);
    return p.grain.diameter * std::exp(std::sqrt(variance) * z - 0.5 * variance);
}

// Grains that are in the air together fall alike, and whoever came later is the slower: each appears at the drop height where nobody is
// who still falls, so that no two meet before one has met the heap. Streams are thin enough for that (heap_family.cpp); a large grain
// of a powder of many sizes may have to wait.
std::vector<Fed> feed_of(const Pour& p) {
    Dice dice(p.seed, 0, 11);
    std::vector<Fed> all;
    const auto clear = [&](const Fed& g) {
        constexpr double margin = 1.01;
        for (auto other = all.rbegin(); other != all.rend(); ++other) {
            const double since = g.due - other->due;
            const double below = g.z - (other->z - 0.5 * gravity * since * since);
            const double reach = margin * (g.radius + other->radius);
            if (std::hypot(g.x - other->x, g.y - other->y, below) < reach) return false;
            if (below > 4.0 * reach) return true;  // nobody else is as high
        }
        return true;
    };
    double latest = 0.0;
    for (int k = 0; k < p.rig.grains; ++k) {
        const double radius = 0.5 * diameter_of(p, dice);
        Fed g{0.0, 0.0, p.rig.drop_height + radius, radius, std::max(latest, k / p.rig.feed_rate)};
        constexpr int draws = 10'000;  // then it waits for a tenth of the time between two grains
        int draw = 0;
        do {
            if (++draw % draws == 0) g.due += 0.1 / p.rig.feed_rate;
            if (draw == 100 * draws)
                throw std::runtime_error("a stream of grains is too dense to be fed");
            const double r = (0.5 * p.rig.feed_diameter - radius) * std::sqrt(dice.uniform());
            const double azimuth = dice.uniform(0.0, 2.0 * pi);
            g.x = r * std::cos(azimuth), g.y = r * std::sin(azimuth);
        } while (!clear(g));
        latest = g.due;
        all.push_back(g);
    }
    return all;
}

struct Place {
    double x, y, z;
};

// The feed stands upright over the middle of the base, z along gravity; the deck's frame is that of the base, which leans down towards
// the azimuth.
Place in_base_frame(const Fed& g, double z, const HeapPhysics& a) {
    const double c = std::cos(a.tilt_angle), s = std::sin(a.tilt_angle);
    const double ex = std::cos(a.tilt_azimuth), ey = std::sin(a.tilt_azimuth);
    const double along = g.x * ex + g.y * ey, across = -g.x * ey + g.y * ex;
    const double u = along * c - z * s, w = along * s + z * c;
    return {u * ex - across * ey, u * ey + across * ex, w};
}

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
thermo 1000000
thermo_style custom step atoms c_way c_turn
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
    double highest = 0.0, largest = d;
    for (const Fed& g : feed)
        highest = std::max(highest, g.z), largest = std::max(largest, 2.0 * g.radius);
    const double shelf = highest + 4.0 * largest, apart = 1.5 * largest;
    const double half = 0.5 * p.rig.base_diameter + 6.0 * d + highest * std::sin(p.acts.tilt_angle);
    std::string data = fmt::format(
        "a heap on glued grains\n\n{} atoms\n2 atom types\n\n{:.12g} {:.12g} xlo xhi\n{:.12g} "
        "{:.12g} ylo yhi\n{:.12g} {:.12g} zlo zhi\n\nAtoms # sphere\n\n",
        feed.size() + glued.size(), -half, half, -half, half, -4.0 * largest,
        shelf + apart * static_cast<double>(feed.size() + 2));
    std::string text = head(p, step, glued.size());
    std::size_t id = 0;
    for (const Fed& g : feed) {
        const Place at = in_base_frame(g, g.z, p.acts);
        ++id;
        data += fmt::format("{} 1 {:.12g} {:.12g} {:.12g} {:.12g} {:.12g}\n", id, 2.0 * g.radius,
                            p.grain.density, at.x, at.y, shelf + apart * static_cast<double>(id));
        text += fmt::format(
            "run {:.0f} upto pre no post no\nset atom {} z {:.12g}\ngroup loose id {}\n",
            std::round(g.due / step), id, at.z, id);
    }
    for (const Place& g : glued)
        data += fmt::format("{} 2 {:.12g} {:.12g} {:.12g} {:.12g} {:.12g}\n", ++id, d,
                            p.grain.density, g.x, g.y, g.z);
    return {{"deck.in", text + rest(p, step)}, {"grains.data", data}};
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
