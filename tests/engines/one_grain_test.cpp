// SPDX-License-Identifier: MIT
#include "cases/read_case.hpp"
#include "engines/lammps_run.hpp"
#include "engines/one_throw.hpp"
#include "engines/peer.hpp"
#include "engines/process.hpp"
#include "scaling/errors.hpp"
#include "tests/engines/scratch.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <string>

using Catch::Matchers::Contains;

namespace {

// A bead of 2 mm and 2500 kg/m^3, soft: a contact of 0.2 ms, so that a run is short.
cases::Case bead(const std::string& physics, double friction, const std::string& modulus = "MPa") {
    const Scratch folder("one-grain-case");
    engines::write_text(folder.path / "case.json",
                        R"({"format": "similitude-case/1", "title": "t",
  "grain": {"diameter": "2 mm", "density": "2500 kg/m^3", "youngs_modulus": "5 )" +
                            modulus + R"(", "poisson_ratio": 0.3},
  "plate": {"youngs_modulus": "8 )" +
                            modulus +
                            R"(", "poisson_ratio": 0.25}, "surroundings": {"gravity": "9.81 m/s^2"},
  "model": {"physics": ["gravity")" +
                            physics + R"(], "parameters": {"restitution": {"value": 0.7},
      "work_of_adhesion": {"value": "0.02 J/m^2"}, "sliding_friction": {"value": )" +
                            std::to_string(friction) + R"(}}},
  "experiments": [
    {"id": "drop", "rig": "drop", "conditions": {"height": "50 mm", "horizontal_speed": "0.2 m/s", "release_time": "10 ms"}},
    {"id": "shots", "rig": "impact", "conditions": {"speed": "1.5 m/s"}},
    {"id": "run", "rig": "incline", "conditions": {"angle": "10 deg"}},
    {"id": "curve", "rig": "pull_off", "conditions": {"counterpart": "plate", "preload": "1 mN"}},
    {"id": "pair", "rig": "pull_off", "conditions": {"counterpart": "grain", "preload": "1 mN"}},
    {"id": "lever", "rig": "pull_off",
      "conditions": {"counterpart": "plate", "preload": "1 mN", "cantilever_stiffness": "1 N/m"}}]})");
    return cases::read_case((folder.path / "case.json").string());
}

// Null, with a word, where it is not installed.
const engines::Peer* installed(const engines::Peer& peer) {
    if (engines::find_program(peer.program)) return &peer;
    WARN("left out: no program " << peer.program);
    return nullptr;
}

rigs::Curves curves_in(const engines::Peer& peer, const cases::Case& c, std::size_t which,
                       const std::vector<double>& at) {
    const Scratch folder("one-grain-" + peer.name);
    return engines::run_one_grain(peer, *engines::find_program(peer.program), c,
                                  c.experiments[which], {at, {}}, folder.path)
        .curves;
}

}  // namespace

TEST_CASE("one grain: what an engine is not told of is refused by name", "[engines][one-grain]") {
    const engines::Peer& peer = GENERATE(from_range(engines::peers()));
    const auto message = [&](const cases::Case& c, std::size_t which) -> std::string {
        try {
            peer.one_grain(c, c.experiments[which], {{0.1}, {}}, {});
        } catch (const scaling::InvalidInput& e) {
            return e.what();
        }
        return "";
    };
    CHECK(message(bead(R"(, "hertz_mindlin")", 0.3), 0).empty());
    cases::Case pulled = bead(R"(, "hertz_mindlin")", 0.3);
    pulled.model.physics.emplace_back("van_der_waals");
    CHECK_THAT(message(pulled, 3), Contains(peer.jkr ? "no van_der_waals in a pull-off"
                                                     : "no deck for the rig pull_off"));
    CHECK_THAT(message(bead(R"(, "hertz_mindlin", "adhesion")", 0.3), 0),
               Contains("adhesion on a single grain"));
    CHECK_THAT(message(bead(R"(, "hertz_coulomb")", 0.3), 0), Contains("hertz_coulomb"));
    cases::Case euler = bead(R"(, "hertz_mindlin")", 0.3);
    euler.model.numerics.integrator = "euler";
    for (const std::size_t which : {0, 1, 2})
        CHECK_THAT(message(euler, which), Contains("not of Euler"));
}

TEST_CASE("one grain: LAMMPS' deck has one run, the wall's dashpot changes with a second",
          "[engines][one-grain]") {
    const cases::Case c = bead(R"(, "hertz_mindlin")", 0.3);
    for (const std::size_t which : {0, 1}) {
        const std::string deck = engines::find_peer("lammps")
                                     ->one_grain(c, c.experiments[which], {{0.1, 0.2}, {}}, {})
                                     .deck;
        const std::size_t run = deck.find("\nrun ");
        REQUIRE(run != std::string::npos);
        CHECK(deck.find("\nrun ", run + 1) == std::string::npos);
    }
}

// The fall by hand: z = h - g t^2/2, first touch after sqrt(2 h/g) = 101 ms, then e sqrt(2 g h) upwards. The dashpot of LAMMPS meets e
// to 1e-3 (restitution_to_tell), which the rebound carries 1e-3 v t = 0.1 mm far in 0.1 s.
TEST_CASE("one grain: a bead falls, bounces and slides on as by hand", "[engines][one-grain]") {
    const engines::Peer& peer = GENERATE(from_range(engines::peers()));
    INFO(peer.title);
    if (installed(peer) == nullptr) return;
    const cases::Case c = bead(R"(, "hertz_mindlin")", 0.0);
    const double g = 9.81, h = 0.05, release = 0.01, first = std::sqrt(2.0 * h / g);
    const std::vector<double> t{
        0.0, 0.005, 0.06, 0.11, release + first + 0.05, release + first + 0.1};
    const rigs::Curves curves = curves_in(peer, c, 0, t);
    const std::vector<double>&z = curves.at("z"), &x = curves.at("x");
    CHECK(z[0] == h);
    CHECK(z[1] == h);
    CHECK(x[1] == 0.0);
    // Verlet's parabola is exact; what is left is half a step times g times a step.
    CHECK(z[2] == Approx(h - 0.5 * g * 0.05 * 0.05).margin(1e-9));
    CHECK(z[3] == Approx(h - 0.5 * g * 0.1 * 0.1).margin(1e-9));
    for (const std::size_t k : {1, 2, 3, 4, 5})
        CHECK(x[k] == Approx(0.2 * std::max(0.0, t[k] - release)).margin(1e-9));
    for (const std::size_t k : {4, 5}) {
        const double since = t[k] - release - first, up = 0.7 * std::sqrt(2.0 * g * h);
        // The contact itself takes 0.3 ms, in which weight does nothing and the bead would have moved by 0.3 mm.
        CHECK(z[k] == Approx(up * since - 0.5 * g * since * since).margin(0.5e-3));
    }
}

// Walton 1993: above atan(7/2 mu (1 + e)) = 0.54 the grain slides all through and loses mu (1 + e) v_n of its way along the plate. In
// LAMMPS to 2e-3. LIGGGHTS multiplies the friction by |F|, and the tension of the dashpot at the end makes that impulse 2.1 % larger
// (Hertz' contact with Tsuji's dashpot, integrated); both LIGGGHTS and Yade let the dashpot act on top while the spring grows, before
// it slides, up to 2 % more. So these lose up to 5 % more than Coulomb's share, never less. Stiff, 0.2 % of R deep, so that the lever is R.
TEST_CASE("one grain: impacts keep e, and what slides loses Coulomb's share",
          "[engines][one-grain]") {
    const engines::Peer& peer = GENERATE(from_range(engines::peers()));
    INFO(peer.title);
    if (installed(peer) == nullptr) return;
    const double mu = 0.1, e = 0.7;
    const cases::Case c = bead(R"(, "hertz_mindlin")", mu, "GPa");
    const std::vector<double> angle{0.0, 0.9, 1.2};
    const rigs::Curves curves = curves_in(peer, c, 1, angle);
    const auto& kept = curves.at("tangential_restitution");
    CHECK(std::isnan(kept[0]));
    for (std::size_t k = 0; k < angle.size(); ++k) {
        INFO(angle[k]);
        CHECK(curves.at("normal_restitution")[k] == Approx(e).margin(1e-3));
        if (k == 0) continue;
        const double share = mu * (1.0 + e) / std::tan(angle[k]), loss = 1.0 - kept[k];
        CHECK(loss >= share - 2e-3);
        CHECK(loss <= share + (peer.name == "lammps" ? 2e-3 : 0.05 * share));
        // 5/2 of the same impulse goes into the spin.
        CHECK(curves.at("rebound_spin")[k] ==
              Approx(2.5 * loss * 1.5 * std::sin(angle[k]) / 1e-3).epsilon(0.01));
    }
}

// From rest a sphere rolls down at 5/7 g sin(a) where it grips (mu > 2/7 tan(a) = 0.05), else it slides at g (sin(a) - mu cos(a)) and
// spins up at 5/2 mu g cos(a)/R. It lies 0.8 um deep, 0.08 % of R, and the spring of friction takes a stretch before it grips.
TEST_CASE("one grain: on a slope it rolls or slides as by hand", "[engines][one-grain]") {
    const engines::Peer& peer = GENERATE(from_range(engines::peers()));
    INFO(peer.title);
    if (installed(peer) == nullptr) return;
    const double g = 9.81, slope = 10.0 * std::numbers::pi / 180.0, t = 0.3;
    for (const double mu : {0.02, 0.3}) {
        const cases::Case c = bead(R"(, "hertz_mindlin")", mu);
        const rigs::Curves curves = curves_in(peer, c, 2, {0.0, 0.5 * t, t});
        const bool grips = mu > 2.0 / 7.0 * std::tan(slope);
        const double a =
            grips ? 5.0 / 7.0 * g * std::sin(slope) : g * (std::sin(slope) - mu * std::cos(slope));
        const double spin_up = grips ? a / 1e-3 : 2.5 * mu * g * std::cos(slope) / 1e-3;
        INFO(mu);
        CHECK(curves.at("s")[0] == 0.0);
        for (const std::size_t k : {1, 2}) {
            const double since = 0.5 * t * static_cast<double>(k);
            CHECK(curves.at("s")[k] == Approx(0.5 * a * since * since).epsilon(0.005));
            CHECK(curves.at("spin")[k] == Approx(spin_up * since).epsilon(0.005));
        }
    }
}

// By hand (Johnson, Kendall & Roberts 1971), L^3 = pi w R*^2/(2 E*): F = 4 E* a^3/(3 R*) - sqrt(8 pi w E* a^3) at an overlap of
// a^2/R* - sqrt(2 pi w a/E*), which is (x^2 - 2 sqrt x) L^2/R* at a = x L. No load at x = 9^(1/3); on the way out -8/9 of 3/2 pi w R* at
// a separation of 0, all of it at x^3 = 9/4, a gap of (3/2)^(1/3)/2 = 0.572 L^2/R*, and there LAMMPS lets go. 1e-9: round-off of
// positions of 2 mm, over gaps of 0.2 um; at the deepest tension the force is stationary, a thousandth of the gap before it 1e-6 less.
TEST_CASE("one grain: LAMMPS' pull-off is JKR's by hand, let go at the deepest tension",
          "[engines][one-grain][lammps]") {
    const engines::Peer& peer = *engines::find_peer("lammps");
    if (installed(peer) == nullptr) return;
    const cases::Case c = bead(R"(, "hertz_mindlin", "adhesion")", 0.3);
    const bool plate = GENERATE(true, false);
    INFO((plate ? "plate" : "grain"));
    const double soft = (1.0 - 0.3 * 0.3) / 5e6, hard = (1.0 - 0.25 * 0.25) / 8e6;
    const double e_star = 1.0 / (soft + (plate ? hard : soft)), r_star = plate ? 1e-3 : 0.5e-3;
    const double w = 0.02, pull = 1.5 * std::numbers::pi * w * r_star;
    const double length = std::cbrt(std::numbers::pi * w * r_star * r_star / (2.0 * e_star));
    const double unit = length * length / r_star, gap = 0.5 * std::cbrt(1.5) * unit;
    const auto separation = [&](double x) { return -(x * x - 2.0 * std::sqrt(x)) * unit; };
    const auto force = [&](double x) {
        const double a3 = std::pow(x * length, 3);
        return 4.0 * e_star * a3 / (3.0 * r_star) -
               std::sqrt(8.0 * std::numbers::pi * w * e_star * a3);
    };
    const double level = std::cbrt(9.0);
    const rigs::Ordinates at{{10.0 * unit, 0.5 * gap, separation(level), separation(4.0),
                              separation(level), 0.0, 0.999 * gap, 1.001 * gap, 10.0 * unit},
                             {false, false, false, false, true, true, true, true, true}};
    const Scratch folder("pull-off");
    const engines::PeerCurvesRun run =
        engines::run_one_grain(peer, *engines::find_program(peer.program), c,
                               c.experiments[plate ? 3 : 4], at, folder.path);
    const std::vector<double>& f = run.curves.at("force");
    const double digits = 1e-9 * pull;
    const std::vector<double> by_hand{0.0, 0.0, 0.0, force(4.0), 0.0, -8.0 / 9.0 * pull,
                                      0.0, 0.0, 0.0};
    for (std::size_t k = 0; k < by_hand.size(); ++k) {
        INFO(k);
        if (k == 6)
            CHECK(f[k] == Approx(-pull).epsilon(2e-6));
        else
            CHECK(f[k] == Approx(by_hand[k]).epsilon(1e-9).margin(digits));
    }
    CHECK_THAT(run.note, Contains("lets go at the deepest tension"));
}

TEST_CASE("one grain: a cantilever is refused for a pull-off in LAMMPS",
          "[engines][one-grain][lammps]") {
    cases::Case c = bead(R"(, "hertz_mindlin", "adhesion")", 0.3);
    cases::Experiment& e = c.experiments[5];
    e.recording = cases::Recording{{{"displacement", "m", {0.0}, {}}, {"force", "N", {0.0}, {}}}};
    CHECK_THROWS_WITH(engines::find_peer("lammps")->one_grain(c, e, {{0.0}, {true}}, {}),
                      Contains("cantilever"));
}
