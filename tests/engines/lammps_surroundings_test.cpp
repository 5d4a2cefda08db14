// SPDX-License-Identifier: MIT
// A pile in a fluid, on a base that is tilted or shakes: LAMMPS is told of the same motion.
#include "engines/lammps_files.hpp"
#include "engines/lammps_pile.hpp"
#include "engines/liggghts_decks.hpp"
#include "engines/pile_feed.hpp"
#include "engines/process.hpp"
#include "engines/yade_decks.hpp"
#include "scaling/errors.hpp"
#include "tests/engines/scratch.hpp"
#include "tests/engines/small_pile.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <string>

using Catch::Matchers::Contains;

namespace {

constexpr double g = 9.81;

// Grains of 1 mm that fall 5 d in 0.032 s.
rigs::PileSetup plain(const std::string& base, int grains) {
    return small_pile(R"({"youngs_modulus": "0.245 MPa", "poisson_ratio": 0.25})", base, "",
                      grains);
}

void put_in_fluid(rigs::PileSetup& s) {
    s.fluid = {{1.2, 700.0, 2e-3}, 700.0};  // tau 0.07 s, Re up to 100
}
void tilt(rigs::PileSetup& s) { s.stand.tilt_angle = 0.2, s.stand.tilt_azimuth = 0.7; }
void shake(rigs::PileSetup& s) {
    const double omega = 2.0 * std::numbers::pi * 70.0;
    s.stand.shaking = {1.5 * g / (omega * omega), omega, 0.4};
}

// The loose grains after so many steps; `grains` in LAMMPS, in the order of their births.
std::vector<dem_min::Grain> in_lammps(const rigs::PileSetup& s, std::int64_t steps,
                                      const std::filesystem::path& folder) {
    engines::Deck deck = engines::lammps_pile(s);
    const std::size_t rest = deck.deck.find("\n# At rest");
    REQUIRE(rest != std::string::npos);
    const bool flat = s.conditions.base == rigs::Base::flat;
    deck.deck = deck.deck.substr(0, rest) + "\nrun " + std::to_string(steps) + " upto" +
                (flat ? " pre no" : "") +
                " post no\nwrite_dump all custom final.dump id type x y z vx vy vz omegax omegay "
                "omegaz radius modify sort id format float %.17g\n";
    engines::write_deck(deck, folder);
    const engines::Finished f =
        engines::run({"lmp", "-in", "deck.in", "-log", "none"}, folder, 60.0);
    INFO(f.out);
    REQUIRE(f.exit_code == 0);
    std::vector<dem_min::Grain> loose;
    for (const dem_min::Grain& grain :
         engines::read_final_grains(folder, engines::loose_density(s)).grains)
        if (!grain.fixed) loose.push_back(grain);
    return loose;
}

}  // namespace

// Before the first contact, along the way of three grains. 1e-4 of d and of the speed without drag: what a batch fell before it was read
// is exact, our own run is off by (omega dt)^2/12 of an amplitude. 1e-3 with drag: its velocities are half a step old there, dt/tau =
// 3e-4. Over a plate a batch begins without its first half kick, since no set-up may come between two runs.
TEST_CASE("lammps surroundings: grains fall there as they do here", "[engines][lammps][pile]") {
    if (!engines::find_program("lmp")) return;
    const std::string base = GENERATE(as<std::string>(), "glued_grains", "flat");
    const int effects = GENERATE(1, 2, 3, 4);
    CAPTURE(base, effects);
    rigs::PileSetup s = plain(base, 3);
    if (effects != 2 && effects != 3) put_in_fluid(s);
    if (effects != 1 && effects != 3) tilt(s);
    if (effects >= 3) shake(s);
    const bool drags = s.fluid.acts();
    const auto steps = static_cast<std::int64_t>(0.024 / s.time_step);
    // At whole steps: in between, our own run lets a grain go at the next step, a batch where it would by then have fallen to.
    for (std::size_t k = 0; k < 3; ++k)
        s.feed_time[k] = 200.0 * static_cast<double>(k) * s.time_step;
    REQUIRE(2 * steps > 3 * 400);
    rigs::PileRun ours = rigs::begin_pile(s, 1);
    rigs::advance(ours, s, steps);
    const dem_min::Particles& p = ours.simulation.grains;
    REQUIRE(pair_count(ours.simulation) + wall_contact_count(ours.simulation) == 0);
    const Scratch folder("lammps-surroundings");
    const auto there = in_lammps(s, steps, folder.path);
    REQUIRE(there.size() == 3);
    const double limit = drags ? 1e-3 : 1e-4;
    const double kick =
        base == "flat" ? (effects >= 3 ? 2.5 : 1.0) * g * 0.5 * s.time_step : 0.0;  // m/s
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t here = p.count() - 3 + k;
        const contact::Vec3 off = there[k].position - p.position(here);
        const contact::Vec3 faster = there[k].velocity - p.velocity(here);
        CAPTURE(k, contact::norm(off) / s.d,
                contact::norm(faster) / contact::norm(p.velocity(here)));
        CHECK(contact::norm(off) < limit * s.d + kick * ours.simulation.time());
        CHECK(contact::norm(faster) < limit * contact::norm(p.velocity(here)) + kick);
    }
}

TEST_CASE("lammps surroundings: LIGGGHTS and Yade refuse them and name LAMMPS",
          "[engines][lammps][pile]") {
    const auto refused = [](void (*effect)(rigs::PileSetup&), const char* word) {
        rigs::PileSetup s = plain("glued_grains", 3);
        REQUIRE_NOTHROW(engines::liggghts_pile(s));
        effect(s);
        CHECK_THROWS_WITH(engines::liggghts_pile(s), Contains(word) && Contains("take lammps"));
        CHECK_THROWS_WITH(engines::yade_pile(s), Contains(word) && Contains("take lammps"));
        CHECK_NOTHROW(engines::lammps_pile(s));
    };
    refused(put_in_fluid, "air_drag");
    refused(tilt, "tilt");
    refused(shake, "vibration");
}
