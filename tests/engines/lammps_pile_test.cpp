// SPDX-License-Identifier: MIT
#include "engines/lammps_pile.hpp"

#include "engines/lammps_dump.hpp"
#include "engines/lammps_files.hpp"
#include "engines/lammps_rules.hpp"
#include "engines/lammps_run.hpp"
#include "engines/pile_feed.hpp"
#include "engines/pile_run.hpp"
#include "engines/process.hpp"
#include "scaling/errors.hpp"
#include "tests/engines/scratch.hpp"
#include "tests/engines/small_pile.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

using Catch::Matchers::Contains;

namespace {

rigs::PileSetup small_setup(const std::string& base, const std::string& physics, int grains) {
    rigs::PileSetup s = small_pile(R"({"youngs_modulus": "0.245 MPa", "poisson_ratio": 0.25})",
                                   base, physics, grains);
    rigs::take_lammps_rules(s);
    return s;
}

// Highest point of a path after it first was below `rest`, above that, m.
double rebound(const std::vector<double>& z, double rest) {
    double top = rest;
    bool met = false;
    std::size_t k = 0;
    for (; k < z.size() && !met; ++k) met = z[k] < rest;
    for (; k < z.size() && z[k] < rest; ++k) {
    }
    for (; k < z.size() && z[k] >= rest; ++k) top = std::max(top, z[k]);
    return top - rest;
}

const char* const all_physics = R"(, "adhesion", "rolling_resistance")";

}  // namespace

TEST_CASE("lammps pile: LAMMPS is told E = 2 E*, so that its wall, which halves it, meets E*",
          "[engines][lammps][pile]") {
    rigs::ContactParameters c{};
    c.e_star = 1e6, c.g_star = 2.5e5, c.sliding_friction = 0.5, c.restitution = 1.0;
    CHECK_THAT(engines::granular_arguments(c, {}, {}),
               Contains("hertz/material 2000000 ") && Contains(" 0 damping tsuji tangential "
                                                               "mindlin_rescale 2000000 1 0.5"));
    c.work_of_adhesion = 0.5, c.rolling_friction = 0.25;
    c.as_lammps = rigs::LammpsRules{500.0, 0.125};
    CHECK_THAT(engines::granular_arguments(c, {}, {}),
               Contains("jkr 2000000 ") && Contains(" 0 0.25 ") &&
                   Contains(" rolling sds 500 0.125 0.25") && Contains(" twisting marshall"));
}

// Manual of 2 Sep 2026: `damping coeff_restitution` gives -2 sqrt(5/6) ln e/sqrt(pi^2 + ln^2 e) sqrt(3/2 k m*) with k = 4/3 E* a, the
// case's own dashpot; it and `tsuji` are "not compatible with cohesive normal models"; `viscoelastic` is eta a m*. By hand for the pair
// below: a0^3 = 9 pi w R*^2/(2 E*) = (1 mm)^3, the dashpot 2 sqrt(5/6) beta sqrt(2 E* a0 m*) with beta = 1/sqrt 2 at e = exp(-pi).
TEST_CASE(
    "lammps pile: later releases are told the restitution itself, and viscoelastic dashpots under "
    "JKR",
    "[engines][lammps][pile]") {
    const engines::DeckOptions later{.lammps = engines::LammpsRelease::later};
    const engines::NominalPair pair{1e-3, 2e-6};
    rigs::ContactParameters c{};
    c.e_star = 1e6, c.g_star = 2.5e5, c.sliding_friction = 0.5, c.restitution = 0.25;
    CHECK(engines::granular_arguments(c, later, pair) ==
          "hertz/material 2000000 0.25 0 damping coeff_restitution tangential mindlin_rescale "
          "2000000 1 0.5");
    c.restitution = std::exp(-std::numbers::pi);
    c.work_of_adhesion = 1e6 * 1e-3 / (4.5 * std::numbers::pi);
    const double dashpot =
        2.0 * std::sqrt(5.0 / 12.0) * std::sqrt(2.0 * 1e6 * 1e-3 * 2e-6);  // kg/s
    CHECK(engines::viscoelastic_eta(c, pair) * 1e-3 * 2e-6 == Approx(dashpot).epsilon(1e-12));
    const std::string jkr = engines::granular_arguments(c, later, pair);
    CHECK_THAT(jkr, Contains(" damping viscoelastic ") && Contains(" twisting marshall"));
    for (const char* refused : {"tsuji", "coeff_restitution"})
        CHECK(jkr.find(refused) == std::string::npos);
}

TEST_CASE("lammps pile: a deck for later releases says that nobody has run it",
          "[engines][lammps][pile]") {
    const engines::DeckOptions later{.lammps = engines::LammpsRelease::later};
    for (const char* base : {"flat", "glued_grains"}) {
        rigs::PileSetup s = small_setup(base, "", 20);
        s.grains.restitution = 0.05;  // coeff_restitution has no polynomial that ends
        const std::string deck = engines::lammps_pile(s, later).deck;
        CHECK_THAT(deck, Contains("UNTESTED") && Contains("\npair_coeff * * hertz/material ") &&
                             Contains(" damping coeff_restitution "));
        CHECK(deck.find("tsuji") == std::string::npos);
        s.grains.restitution = 0.0;
        CHECK_THROWS_WITH(engines::lammps_pile(s, later), Contains("coeff_restitution"));
    }
    CHECK(engines::lammps_pile(small_setup("flat", "", 20)).deck.find("UNTESTED") ==
          std::string::npos);
}

TEST_CASE("lammps pile: the traps of the release are kept out of the deck",
          "[engines][lammps][pile]") {
    const rigs::PileSetup s = small_setup("glued_grains", all_physics, 40);
    const std::string deck = engines::lammps_pile(s).deck;
    const std::size_t step = deck.find("\ntimestep ");
    REQUIRE(step != std::string::npos);
    CHECK(step < deck.find("\nfix "));  // gravity, pour and walls take the step when they are made
    CHECK(deck.find("\nread_restart ") == std::string::npos);  // crashes with jkr
    CHECK(deck.find("write_data ") != std::string::npos);
    CHECK(deck.find("pair/local") == std::string::npos);            // omits stretched contacts
    for (const auto& [name, text] : engines::lammps_pile(s).files)  // crashes with several ranks
        CHECK(text.find("Velocities") == std::string::npos);
    // A sort at the start of each of the feed's runs loses springs of contacts.
    CHECK(deck.find("\natom_modify sort 0 0.0\n") < deck.find("create_box"));
    CHECK(deck.find("newton off") < deck.find("create_box"));
    CHECK(deck.find("thermo_modify lost ignore") > deck.find("thermo_style"));
}

TEST_CASE("lammps pile: what LAMMPS has not is refused by name", "[engines][lammps][pile]") {
    const auto message = [](rigs::PileSetup s) -> std::string {
        try {
            engines::lammps_pile(s);
        } catch (const scaling::InvalidInput& e) {
            return e.what();
        }
        return "";
    };
    const rigs::PileSetup good = small_setup("glued_grains", all_physics, 20);
    CHECK(message(good) == "");
    rigs::PileSetup s = good;
    s.grains.as_lammps.reset();
    CHECK_THAT(message(s), Contains("EPSD") && Contains("--contact lammps"));
    s = good, s.conditions.base = rigs::Base::flat_with_rim;
    CHECK_THAT(message(s), Contains("rim") && Contains("glued_grains"));
    s = good, s.conditions.base = rigs::Base::flat;
    CHECK(message(s) == "");
    s.walls.work_of_adhesion = 0.01;
    CHECK_THAT(message(s), Contains("adhesive contact with a wall"));
    s.walls.work_of_adhesion = 0.0, s.walls.restitution = 0.1;
    CHECK_THAT(message(s), Contains("0.12"));
    s = good, s.conditions.funnel = rigs::Funnel{1e-3, 2e-3, 1e-3, 1e-3};
    CHECK_THAT(message(s), Contains("funnel"));
    s = good, s.grains.rigid_tangential = true;
    CHECK_THAT(message(s), Contains("hertz_coulomb"));
    s = good, s.grains.friction_cap = contact::FrictionCap::elastic;
    CHECK_THAT(message(s), Contains("friction_cap"));
    s = good, s.grains.bridge = {.pull_per_radius = 1.0, .volume = 1e-15, .rupture_gap = 1e-5};
    CHECK_THAT(message(s), Contains("capillary_bridge"));
    s = good, s.grains.ageing.rate = 0.1;
    CHECK_THAT(message(s), Contains("ageing"));
    s = good, s.grains.restitution = 0.1;
    CHECK_THAT(message(s), Contains("0.12"));
    s = good, s.sleep_speed = 1.0;
    CHECK_THAT(message(s), Contains("--sleep"));
}

// t = sqrt(2 s/g): a batch spans sqrt(d/g), so that its first grain has fallen d/2.
TEST_CASE("lammps pile: every grain is read once, at most d/2 below where it appeared",
          "[engines][lammps][pile]") {
    const rigs::PileSetup s = small_setup("glued_grains", all_physics, 200);
    const auto batches = engines::feed_batches(s);
    std::size_t next = 0;
    for (const engines::FeedBatch& b : batches) {
        CHECK(b.first == next);
        next = b.last + 1;
        const double read = static_cast<double>(b.step) * s.time_step;
        CHECK(read >= s.feed_time[b.last]);
        const double flown = read - s.feed_time[b.first];
        CHECK(0.5 * s.gravity * flown * flown <= 0.51 * s.d);  // half a d and one step
    }
    CHECK(next == 200);
    CHECK(batches.size() > 10);
}

// It bounces among glued grains and comes to rest in a hollow: each oblique bounce makes the difference of the two integrators larger.
TEST_CASE("lammps pile: one grain falls in LAMMPS as it does here", "[engines][lammps][pile]") {
    if (!engines::find_program("lmp")) return;
    const rigs::PileSetup s = small_setup("glued_grains", all_physics, 1);
    const Scratch folder("lammps-pile-one");
    engines::write_deck(engines::lammps_pile(s), folder.path);
    const auto run = engines::run_pile(*engines::find_peer("lammps"), "lmp", s, folder.path, 1);
    REQUIRE(run.end);
    CHECK(run.end->record.at_rest);
    REQUIRE(run.end->record.heap.centre.size() == 1);
    rigs::PileRun ours = rigs::begin_pile(s, 1);
    while (!ours.finished) rigs::advance(ours, s, 1000);
    const rigs::PileRecord here = rigs::record(ours, s);
    CHECK(std::abs(here.heap.centre[0].x - run.end->record.heap.centre[0].x) < 1e-3 * s.d);
    CHECK(std::abs(here.heap.centre[0].z - run.end->record.heap.centre[0].z) < 1e-3 * s.d);
    CHECK(std::abs(here.steps - run.end->record.steps) <= 200);  // two looks at rest
    CHECK(run.end->record.coordination == here.coordination);
}

TEST_CASE("lammps pile: a heap comes back whole, and the lost are counted",
          "[engines][lammps][pile]") {
    if (!engines::find_program("lmp") || !engines::find_program("mpirun")) return;
    const rigs::PileSetup s = small_setup("glued_grains", all_physics, 120);
    const Scratch folder("lammps-pile-heap");
    engines::write_deck(engines::lammps_pile(s), folder.path);
    std::int64_t shown = 0;
    const auto run = engines::run_pile(*engines::find_peer("lammps"), "lmp", s, folder.path, 2,
                                       [&](const engines::DeckProgress& p) { shown = p.step; });
    CHECK(shown > 0);
    REQUIRE(run.end);
    const rigs::PileRecord& r = run.end->record;
    CHECK(r.at_rest);
    CHECK(r.heap.centre.size() + static_cast<std::size_t>(r.grains_lost) == 120);
    CHECK(r.grains_lost > 0);
    CHECK(r.heap.centre.size() > 20);
    for (const contact::Vec3& p : r.heap.centre) {
        CHECK(p.z > s.lost_below);
    }
    CHECK(r.coordination > 2.0);
    // No grain was read into another: the deepest overlap at rest is far from a grain.
    double deepest = 0.0;
    for (std::size_t i = 0; i < r.heap.centre.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const contact::Vec3 way = r.heap.centre[i] - r.heap.centre[j];
            deepest = std::max(deepest, s.d - std::sqrt(dot(way, way)));
        }
    CHECK(deepest < 0.05 * s.d);
}

// Grains that are fed apart, one after the other, each in a batch of its own: the last meets the plate as the first does, and all as
// they do here. Highest point after the bounce against the fall, e^2, which the dashpot of a wall set up anew would move by 0.1.
TEST_CASE("lammps pile: on a flat base every batch bounces with the stated restitution",
          "[engines][lammps][pile]") {
    if (!engines::find_program("lmp")) return;
    rigs::PileSetup s = small_setup("flat", "", 6);
    s.conditions.drop_height = 5e-3;
    s.time_step /= 8.0;  // a bounce in few steps scatters with the phase at which it begins
    for (std::size_t k = 0; k < 6; ++k)
        s.feed_time[k] = 0.04 * static_cast<double>(k),
        s.feed_x[k] = 1.2e-3 * (static_cast<double>(k) - 2.5), s.feed_y[k] = 0.0;
    REQUIRE(engines::feed_batches(s).size() == 6);
    engines::Deck deck = engines::lammps_pile(s);
    const std::string feed = "run 0 post no\nlabel feed\n";
    REQUIRE(deck.deck.find(feed) != std::string::npos);
    deck.deck.insert(deck.deck.find(feed),
                     "dump path all custom 160 path.dump id z\ndump_modify path sort id\n");
    const Scratch folder("lammps-pile-plate");
    engines::write_deck(deck, folder.path);
    const auto run = engines::run_pile(*engines::find_peer("lammps"), "lmp", s, folder.path, 1);
    REQUIRE(run.end);
    CHECK(run.end->record.heap.centre.size() == 6);
    CHECK(run.end->record.coordination == 1.0);  // each lies on the plate

    const auto frames = engines::read_lammps_frames(folder.path / "path.dump");
    rigs::PileRun ours = rigs::begin_pile(s, 1);
    std::vector<std::vector<double>> here(6);
    while (!ours.finished) {
        rigs::advance(ours, s, 160);
        for (std::size_t k = 0; k < ours.simulation.grains.count(); ++k)
            here[k].push_back(ours.simulation.grains.z[k]);
    }
    for (std::size_t k = 0; k < 6; ++k) {
        std::vector<double> there;
        for (const engines::LammpsFrame& f : frames)
            if (static_cast<double>(f.step) * s.time_step > s.feed_time[k])
                there.push_back(f.rows[k][1]);
        const double e2_there = rebound(there, s.radius[k]) / s.conditions.drop_height;
        const double e2_here = rebound(here[k], s.radius[k]) / s.conditions.drop_height;
        INFO("grain " << k << ": " << e2_there << " in LAMMPS, " << e2_here << " here");
        CHECK(std::abs(e2_there - e2_here) < 2e-3);
        CHECK(std::abs(e2_there - 0.25) < 0.01);  // the plate is soft: gravity acts in the contact
    }
}

TEST_CASE("lammps pile: a heap on a flat base comes back whole, and the lost are counted",
          "[engines][lammps][pile]") {
    if (!engines::find_program("lmp") || !engines::find_program("mpirun")) return;
    const rigs::PileSetup s = small_setup("flat", all_physics, 120);
    const Scratch folder("lammps-pile-flat");
    engines::write_deck(engines::lammps_pile(s), folder.path);
    const int ranks = GENERATE(1, 2);
    const auto run = engines::run_pile(*engines::find_peer("lammps"), "lmp", s, folder.path, ranks);
    REQUIRE(run.end);
    const rigs::PileRecord& r = run.end->record;
    CHECK(r.at_rest);
    CHECK(r.heap.centre.size() + static_cast<std::size_t>(r.grains_lost) == 120);
    CHECK(r.grains_lost > 0);
    CHECK(r.heap.centre.size() > 10);
    for (const contact::Vec3& p : r.heap.centre) {
        CHECK(p.z > 0.45 * s.d);  // soft and sticky: overlaps of up to 0.05 d, as above
        CHECK(std::hypot(p.x, p.y) < r.base_radius + 1.5 * s.d);
    }
}

// A glued grain hangs where the first one is to appear, 0.3 d off its centre; without the loop the two would lie 0.7 d deep in one another.
TEST_CASE("lammps pile: no grain is fed into another", "[engines][lammps][pile]") {
    if (!engines::find_program("lmp")) return;
    const rigs::PileSetup s = small_setup("glued_grains", "", 1);
    engines::Deck deck = engines::lammps_pile(s);
    const std::string look =
        "write_dump all custom fed.dump id x y z radius modify format float %.17g\n";
    const std::string clear = "label clear\n";
    deck.deck.insert(deck.deck.find(clear) + clear.size(), look);
    const std::size_t glued = engines::glued_grains(s).size();
    std::string& base = deck.files.front().second;
    REQUIRE(deck.files.front().first == "base.data");
    const std::string count = std::to_string(glued) + " atoms";
    REQUIRE(base.find(count) != std::string::npos);
    base.replace(base.find(count), count.size(), std::to_string(glued + 1) + " atoms");
    base += std::to_string(glued + 1) + " 2 " + std::to_string(s.feed_x[0]) + ' ' +
            std::to_string(s.feed_y[0] + 0.1 * s.d) + ' ' +
            std::to_string(s.conditions.drop_height + s.radius[0] + 0.28 * s.d) + ' ' +
            std::to_string(s.d) + " 2500 0\n";
    const Scratch folder("lammps-pile-within");
    engines::write_deck(deck, folder.path);
    engines::run_pile(*engines::find_peer("lammps"), "lmp", s, folder.path, 1);
    const auto frames = engines::read_lammps_frames(folder.path / "fed.dump");
    const engines::LammpsFrame& f = frames.front();
    REQUIRE(f.rows.size() == glued + 2);
    const std::vector<double>& fed = f.rows.back();
    for (std::size_t k = 0; k + 1 < f.rows.size(); ++k) {
        double square = 0.0;
        for (const std::size_t axis : {1, 2, 3})
            square += (fed[axis] - f.rows[k][axis]) * (fed[axis] - f.rows[k][axis]);
        CHECK(std::sqrt(square) >= fed[4] + f.rows[k][4]);
    }
    CHECK(fed[3] <
          s.conditions.drop_height + s.radius[0] + 2.0 * s.d);  // and no higher than need be
}

TEST_CASE("lammps pile: what an earlier run left in the folder is gone",
          "[engines][lammps][pile]") {
    const Scratch folder("lammps-pile-earlier");
    for (const char* file : {"log.lammps", "final.dump", "final.data", "rows.dump"})
        engines::write_text(folder.path / file, "of an earlier run");
    engines::write_deck(engines::lammps_pile(small_setup("glued_grains", all_physics, 5)),
                        folder.path);
    for (const char* file : {"log.lammps", "final.dump", "final.data", "rows.dump"})
        CHECK_FALSE(std::filesystem::exists(folder.path / file));
}

TEST_CASE("lammps pile: an error of LAMMPS is told with its log", "[engines][lammps][pile]") {
    if (!engines::find_program("lmp")) return;
    const rigs::PileSetup s = small_setup("glued_grains", all_physics, 5);
    engines::Deck deck = engines::lammps_pile(s);
    deck.deck += "nonsense here\n";
    deck.deck.insert(0, "nonsense here\n");
    const Scratch folder("lammps-pile-error");
    engines::write_deck(deck, folder.path);
    CHECK_THROWS_WITH(engines::run_pile(*engines::find_peer("lammps"), "lmp", s, folder.path, 1),
                      Contains("nonsense here") && Contains("log.lammps"));
}
