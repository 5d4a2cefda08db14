// SPDX-License-Identifier: MIT
// What the bench is made of. No speed is tested: it would be the machine's.
#include "bench/compare.hpp"
#include "bench/machine.hpp"
#include "bench/scaling.hpp"
#include "scaling/errors.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

using engines::Bed;
using engines::BedFigures;

namespace {

Bed small() {
    Bed bed;
    bed.nx = bed.ny = 4;
    bed.nz = 3;
    bed.warm_up = 20;
    bed.steps = 20;
    return bed;
}

}  // namespace

TEST_CASE("bench: on our core the bed falls freely until its first contact", "[bench]") {
    // The lowest gap is 1.2e-7 m less a jitter of up to 1e-7 m: at least 2e-8 m, which takes
    // sqrt(2 * 2e-8/9.4) = 6.5e-5 s or 84 steps. Before that every grain has v = g t, here with the
    // last half kick included: E = n m (g t)^2/2.
    const Bed bed = small();
    const BedFigures f = bench::run_ours(bed, 1);
    const double mass = 4.0 / 3.0 * std::acos(-1.0) * std::pow(120e-6, 3) * 5600.0;
    const double speed = 9.81 * 40 * 7.78e-7;
    CHECK(f.grains == 48);
    CHECK(f.neighbours == 0.0);
    CHECK(f.kinetic_energy == Approx(48 * 0.5 * mass * speed * speed).epsilon(1e-11));  // round-off
    CHECK(f.seconds > 0.0);
}

TEST_CASE("bench: progress rises from 0 to 1 over warm-up and timed steps", "[bench]") {
    Bed bed = small();
    bed.warm_up = 250;
    std::vector<double> seen;
    bench::run_ours(bed, 1, [&](double share) { seen.push_back(share); });
    REQUIRE(seen.size() == 4);  // 100, 200, 250 and 270 steps of 270
    CHECK(seen[0] == Approx(100.0 / 270.0));
    CHECK(seen[2] == Approx(250.0 / 270.0));
    CHECK(seen[3] == Approx(1.0));
}

TEST_CASE("bench: median, lowest and highest", "[bench]") {
    const bench::Spread odd = bench::spread_of({3.0, 1.0, 9.0});
    CHECK(odd.median == 3.0);
    CHECK(odd.low == 1.0);
    CHECK(odd.high == 9.0);
    CHECK(bench::spread_of({4.0, 1.0, 2.0, 9.0}).median == 3.0);
}

TEST_CASE("bench: a ratio belongs to two neighbouring runs", "[bench]") {
    // The machine halves its speed after the first pair: the ratios do not see it.
    bench::Timed ours, theirs;
    for (const double seconds : {1.0, 2.0}) {
        ours.runs.emplace_back().seconds = seconds;
        theirs.runs.emplace_back().seconds = 3.0 * seconds;
    }
    CHECK(bench::ratios(ours, theirs) == std::vector<double>{3.0, 3.0});
}

TEST_CASE("bench: the settled lattice carries no load", "[bench]") {
    const Bed bed = bench::settled_bed(10, 10, 10);
    const double r_star = 60e-6, overlap = 2.0 * 120e-6 - bed.lattice();
    const double e_star = 156e6 / (2.0 * (1.0 - 0.09));
    const contact::Jkr law{e_star, 0.38};
    const double force = law.at(r_star, law.length_scale(r_star), overlap).force;
    CHECK(overlap > 0.0);
    // The spacing is a number near 2: its last bit is 1e-9 of the overlap.
    CHECK(std::abs(force) < 1e-8 * law.pull_off_force(r_star));
}

TEST_CASE("bench: the moved bytes count what changes twice and what is looked up once", "[bench]") {
    // By hand: 12 numbers of 8 B a grain, nine of them written too; a contact of alike grains has
    // two indices of 4 B and seven numbers both ways. Wall contacts likewise, but that the walls of
    // the bed have no twisting either. 27 grains in one tile have no inbox, and no candidates where
    // all that are near touch.
    const Bed bed = bench::settled_bed(3, 3, 3);
    dem_min::Simulation s = bench::simulation_of(bed, 1);
    dem_min::advance(s, 2);
    const std::size_t contacts = pair_count(s) + wall_contact_count(s);
    std::size_t candidates = 0;
    for (const dem_min::Tile& tile : s.tiles)
        candidates += tile.near_grains.count() + tile.near_walls.count();
    CHECK(pair_count(s) >= 3 * 18);  // each with its two neighbours in x and in y, and those above
    CHECK(bytes_moved(s) == 27 * (12 + 9) * 8 + contacts * (2 * 4 + 2 * 7 * 8) + candidates * 8);
}

TEST_CASE("bench: two sizes and one size with as many grains", "[bench]") {
    // Free sites of a cell, by hand: offsets 1, 3, 5, 7, 9 (in small radii) from the middle with
    // a^2 + b^2 + c^2 >= 121. In one octant, by (a, b, c) rising:
    //   (1,7,9) 131, (3,7,9) 139, (5,7,9) 155 : 6 orders each
    //   (5,5,9) 131, (7,7,9) 179, (1,9,9) 163, (3,9,9) 171, (5,9,9) 187, (7,9,9) 211,
    //   (5,7,7) 123 : 3 orders each
    //   (7,7,7) 147, (9,9,9) 243 : 1 order each
    // Inside are the next, (3,5,9) 115 and (3,7,7) 107. So 18 + 21 + 2 = 41 in an octant, 328 in a
    // cell, and with the large grain in each of two cells 2 * 329 grains.
    const bench::PolydisperseStudy study =
        bench::polydisperse_study(1, 5, 5, 1, 1, [](double, const std::string&) {});
    CHECK(study.mixed.grains == 2 * 329);
    CHECK(study.equal.grains == Approx(2 * 329).epsilon(0.1));  // as near as a lattice comes
}

TEST_CASE("bench: unknown engines are answered with the nearest name", "[bench]") {
    CHECK_THROWS_WITH(bench::engines_for({"lampps"}), Catch::Contains("did you mean lammps?"));
    CHECK_THROWS_AS(bench::engines_for({"lampps"}), scaling::InvalidInput);
}

TEST_CASE("bench: the machine has a name, cores and memory", "[bench]") {
    const bench::Machine m = bench::this_machine();
    CHECK_FALSE(m.processor.empty());
    CHECK(m.cores >= 1);
    CHECK(m.memory > 1e8);
    CHECK(bench::busy({"", 2, 0.0, 1.0}));
    CHECK_FALSE(bench::busy({"", 2, 0.0, 0.1}));
    // Faster than a floppy disk, slower than any memory there is: units are not mixed up.
    const double bandwidth = bench::triad_bandwidth(1e6, 2);
    CHECK(bandwidth > 1e7);
    CHECK(bandwidth < 1e14);
}
