// SPDX-License-Identifier: MIT
#include "engines/lammps_run.hpp"
#include "engines/liggghts_decks.hpp"
#include "engines/nearest.hpp"
#include "engines/pile_run.hpp"
#include "engines/process.hpp"
#include "engines/yade_decks.hpp"
#include "scaling/errors.hpp"
#include "tests/engines/scratch.hpp"
#include "tests/engines/small_pile.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

using Catch::Matchers::Contains;

namespace {

// A plate of another material.
rigs::PileSetup small_setup(const std::string& base, const std::string& physics, int grains) {
    return small_pile(R"({"youngs_modulus": "0.4 MPa", "poisson_ratio": 0.4})", base, physics,
                      grains);
}

const char* const rolling = R"(, "rolling_resistance")";
const char* const sticky = R"(, "adhesion")";

std::string message(const engines::Peer& peer, const rigs::PileSetup& s, bool nearest = false) {
    try {
        peer.pile(s, {.option = "--engine", .nearest = nearest});
    } catch (const scaling::InvalidInput& e) {
        return e.what();
    }
    return "";
}

rigs::PileRecord heap_in(const engines::Peer& peer, const rigs::PileSetup& s, int ranks = 1,
                         bool nearest = false) {
    const Scratch folder("peer-pile-" + peer.name);
    engines::write_deck(peer.pile(s, {.option = "--engine", .nearest = nearest}), folder.path);
    std::int64_t shown = 0;
    const auto run =
        engines::run_pile(peer, *engines::find_program(peer.program), s, folder.path, ranks,
                          [&](const engines::DeckProgress& p) { shown = p.step; });
    CHECK(shown > 0);
    CHECK(run.deck.release != "unknown");
    REQUIRE(run.end);
    return run.end->record;
}

bool installed(const engines::Peer& peer) {
    if (engines::find_program(peer.program)) return true;
    WARN("left out: no program " << peer.program);
    return false;
}

// No grain was read into another: the deepest overlap at rest is far from a grain.
void check_whole(const rigs::PileRecord& r, const rigs::PileSetup& s) {
    CHECK(r.at_rest);
    CHECK(r.heap.centre.size() + static_cast<std::size_t>(r.grains_lost) == s.feed_time.size());
    CHECK(r.heap.centre.size() > 15);
    double deepest = 0.0;
    for (std::size_t i = 0; i < r.heap.centre.size(); ++i) {
        CHECK(r.heap.centre[i].z > s.lost_below);
        for (std::size_t j = 0; j < i; ++j) {
            const contact::Vec3 way = r.heap.centre[i] - r.heap.centre[j];
            deepest = std::max(deepest, s.d - std::sqrt(dot(way, way)));
        }
    }
    CHECK(deepest > 0.0);
    CHECK(deepest < 0.05 * s.d);
}

const engines::Peer& liggghts() { return *engines::find_peer("liggghts"); }
const engines::Peer& yade() { return *engines::find_peer("yade"); }

}  // namespace

// 1/E* = sum (1 - nu^2)/E, 1/G* = sum 2 (2 - nu)(1 + nu)/E (Johnson 1985; Mindlin 1949).
TEST_CASE("liggghts: two materials are told that give back E* and G* of both pairs",
          "[engines][liggghts]") {
    const auto stars = [](engines::Elastic a, engines::Elastic b) {
        const auto normal = [](engines::Elastic m) {
            return (1.0 - m.poisson_ratio * m.poisson_ratio) / m.youngs_modulus;
        };
        const auto shear = [](engines::Elastic m) {
            return 2.0 * (2.0 - m.poisson_ratio) * (1.0 + m.poisson_ratio) / m.youngs_modulus;
        };
        return std::pair{1.0 / (normal(a) + normal(b)), 1.0 / (shear(a) + shear(b))};
    };
    const engines::Elastic glass{63e9, 0.23}, steel{210e9, 0.3};
    const auto [e_gg, g_gg] = stars(glass, glass);
    const auto [e_gs, g_gs] = stars(glass, steel);
    const engines::Elastic grain = engines::material_of_pair(e_gg, g_gg);
    CHECK(grain.youngs_modulus == Approx(63e9).epsilon(1e-12));
    CHECK(grain.poisson_ratio == Approx(0.23).epsilon(1e-12));
    const engines::Elastic wall = engines::material_against(grain, e_gs, g_gs);
    CHECK(wall.youngs_modulus == Approx(210e9).epsilon(1e-10));
    CHECK(wall.poisson_ratio == Approx(0.3).epsilon(1e-10));
}

TEST_CASE("liggghts and yade: what they have not is refused by name", "[engines][peers]") {
    const rigs::PileSetup good = small_setup("glued_grains", "", 20);
    for (const engines::Peer* peer : {&liggghts(), &yade()}) {
        INFO(peer->title);
        CHECK(message(*peer, good) == "");
        rigs::PileSetup s = good;
        s.conditions.base = rigs::Base::flat_with_rim;
        CHECK_THAT(message(*peer, s), Contains(peer->name) && Contains("glued_grains"));
        s = good, s.conditions.funnel = rigs::Funnel{1e-3, 2e-3, 1e-3, 1e-3};
        CHECK_THAT(message(*peer, s), Contains("funnel"));
        s = good, s.grains.rigid_tangential = true;
        CHECK_THAT(message(*peer, s), Contains("hertz_coulomb"));
        s = good, s.sleep_speed = 1.0;
        CHECK_THAT(message(*peer, s), Contains("--sleep"));
        s = small_setup("glued_grains", sticky, 20);
        CHECK_THAT(message(*peer, s), Contains("JKR") && Contains("--contact nearest"));
        CHECK(message(*peer, s, true) == "");
    }
    CHECK(message(liggghts(), small_setup("glued_grains", rolling, 20)) == "");
    CHECK(message(liggghts(), small_setup("flat", rolling, 20)) == "");
    CHECK_THAT(message(yade(), small_setup("flat", "", 20)), Contains("round plate"));
    CHECK_THAT(message(yade(), small_setup("glued_grains", rolling, 20)),
               Contains("EPSD") && Contains("--contact nearest"));
    rigs::PileSetup s = small_setup("glued_grains", rolling, 20);
    rigs::take_lammps_rules(s);
    CHECK_THAT(message(liggghts(), s), Contains("SDS"));
    s = good, s.grains.restitution = 0.05;
    CHECK_THAT(message(liggghts(), s), Contains("0.05"));
}

// A polygon of 96 sides in a circle has the area 48 sin(2 pi/96) of its square radius.
TEST_CASE("liggghts: the disc's triangles cover it once and look up", "[engines][liggghts]") {
    std::istringstream in(engines::disc_stl(2.0));
    double area = 0.0;
    std::vector<std::array<double, 2>> corners;
    for (std::string word; in >> word;) {
        if (word != "vertex") continue;
        double x = 0.0, y = 0.0, z = 1.0;
        in >> x >> y >> z;
        CHECK(z == 0.0);
        corners.push_back({x, y});
        if (corners.size() < 3) continue;
        const auto& [a, b, c] = std::tie(corners[0], corners[1], corners[2]);
        const double twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        CHECK(twice > 0.0);
        area += 0.5 * twice;
        corners.clear();
    }
    CHECK(area == Approx(4.0 * 48.0 * std::sin(2.0 * std::numbers::pi / 96.0)).epsilon(1e-12));
}

// Over the middle of a hollow it stays in it: that of four grains on a square lattice of d, at a height of d/sqrt(2) over their
// centres, less the overlap that four contacts under m g make, some 1e-3 d here.
TEST_CASE("liggghts and yade: one grain comes to rest in a hollow of the base",
          "[engines][peers][pile]") {
    rigs::PileSetup s = small_setup("glued_grains", "", 1);
    s.feed_x[0] = s.feed_y[0] = 0.0;  // over the middle of a hollow
    for (const engines::Peer* peer : {&liggghts(), &yade()}) {
        if (!installed(*peer)) continue;
        INFO(peer->title);
        const rigs::PileRecord r = heap_in(*peer, s);
        CHECK(r.at_rest);
        REQUIRE(r.heap.centre.size() == 1);
        const contact::Vec3 p = r.heap.centre[0];
        CHECK(p.z + 0.5 * s.d == Approx(s.d / std::numbers::sqrt2).margin(3e-3 * s.d));
        for (const double x : {p.x, p.y})
            CHECK(std::abs(x - s.d * std::round(x / s.d)) < 0.02 * s.d);
        CHECK(r.coordination == 4.0);
    }
}

TEST_CASE("liggghts and yade: a heap comes back whole, and the lost are counted",
          "[engines][peers][pile]") {
    SECTION("LIGGGHTS, glued grains, rolling resistance, two ranks") {
        if (!installed(liggghts()) || !engines::find_program("mpirun")) return;
        const rigs::PileSetup s = small_setup("glued_grains", rolling, 60);
        check_whole(heap_in(liggghts(), s, 2), s);
    }
    SECTION("LIGGGHTS, a flat disc") {
        if (!installed(liggghts())) return;
        const rigs::PileSetup s = small_setup("flat", rolling, 120);
        const rigs::PileRecord r = heap_in(liggghts(), s);
        check_whole(r, s);
        CHECK(r.grains_lost > 0);
        // On the plate: no lower than a grain that carries the whole heap would lie.
        const auto low = std::min_element(
            r.heap.centre.begin(), r.heap.centre.end(),
            [](const contact::Vec3& a, const contact::Vec3& b) { return a.z < b.z; });
        CHECK(low->z > 0.48 * s.d);
        CHECK(low->z < 0.5 * s.d);
    }
    SECTION("Yade, glued grains") {
        if (!installed(yade())) return;
        const rigs::PileSetup s = small_setup("glued_grains", "", 120);
        const rigs::PileRecord r = heap_in(yade(), s);
        check_whole(r, s);
        CHECK(r.grains_lost > 0);
    }
    SECTION("the nearest of adhesion") {
        const rigs::PileSetup s = small_setup("glued_grains", sticky, 80);
        for (const engines::Peer* peer : {&liggghts(), &yade()}) {
            if (!installed(*peer)) continue;
            INFO(peer->title);
            CHECK(heap_in(*peer, s, 1, true).at_rest);
        }
    }
}

// Sjkr: 4/3 E* sqrt(R*) d^1.5 - c d, c = 2 pi R* k, deepest at 4/9 of the overlap d0 where it is nothing; of the same deepest tension as
// JKR, c^3 = 12 E*^2 R* F_po. Its lens is smaller than 2 pi R* d by d/(4 R): up to 0.7 % here, which goes into d0 by its square and into
// the work by its fifth power. DMT: 4/3 E* sqrt(R*) d^1.5 - F_po. Both end at touch. Rows lie 1/2000 of the way apart.
TEST_CASE("liggghts and yade: the nearest of adhesion has JKR's pull-off force and not its neck",
          "[engines][peers]") {
    const rigs::PileSetup s = small_setup("glued_grains", sticky, 5);
    const double r = 0.25 * s.d, e_star = s.grains.e_star, w = s.grains.work_of_adhesion;
    const double pull_off = 1.5 * std::numbers::pi * w * r;
    const engines::Separation jkr = engines::jkr_separation(w, r, e_star);
    CHECK(jkr.pull_off == Approx(pull_off).epsilon(1e-12));
    CHECK(jkr.at_touch == Approx(8.0 / 9.0 * pull_off).epsilon(1e-9));
    CHECK(jkr.gap ==
          Approx(0.75 * std::cbrt(std::pow(std::numbers::pi * w, 2) * r / (e_star * e_star)))
              .epsilon(1e-9));
    for (const engines::Peer* peer : {&liggghts(), &yade()}) {
        if (!installed(*peer)) continue;
        INFO(peer->title);
        const Scratch folder("peer-apart");
        const engines::Separation its = engines::measured_separation(
            *peer, *engines::find_program(peer->program), s, folder.path);
        const bool sjkr = peer->name == "liggghts";
        CHECK(its.pull_off == Approx(pull_off).epsilon(sjkr ? 0.01 : 1e-3));
        CHECK(its.at_touch == Approx(sjkr ? 0.0 : pull_off).margin(0.02 * pull_off));
        CHECK(its.gap == 0.0);
        const double hertz = 4.0 / 3.0 * e_star * std::sqrt(r);
        const double k_area = std::cbrt(12.0 * e_star * e_star * r * pull_off);
        const double balance =
            sjkr ? std::pow(k_area / hertz, 2) : std::pow(pull_off / hertz, 2.0 / 3.0);
        CHECK(its.overlap == Approx(balance).epsilon(sjkr ? 0.02 : 0.005));
        // The work: (1/2 - 2/5) k A d0 of sjkr, (1 - 2/5) F_po d0 of DMT.
        const double work = sjkr ? 0.1 * k_area * balance * balance : 0.6 * pull_off * balance;
        CHECK(its.work == Approx(work).epsilon(sjkr ? 0.04 : 0.01));
    }
}

TEST_CASE("liggghts and yade: an error is told with its log", "[engines][peers]") {
    const rigs::PileSetup s = small_setup("glued_grains", "", 5);
    for (const engines::Peer* peer : {&liggghts(), &yade()}) {
        if (!installed(*peer)) continue;
        engines::Deck deck = peer->pile(s, {});
        deck.deck.insert(0, "nonsense_here 1 2\n");
        const Scratch folder("peer-pile-error");
        engines::write_deck(deck, folder.path);
        CHECK_THROWS_WITH(
            engines::run_pile(*peer, *engines::find_program(peer->program), s, folder.path, 1),
            Contains(peer->title) && Contains("rror") && Contains(peer->log));
    }
}
