// SPDX-License-Identifier: MIT
// With the real program: package lammps.
#include "verify/against_lammps.hpp"

#include "engines/lammps_run.hpp"
#include "tests/engines/scratch.hpp"
#include "verify/lammps_heaps.hpp"
#include "verify/lammps_two_grains.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <filesystem>

namespace {

void require_all(const std::vector<verify::Check>& checks, std::size_t at_least) {
    for (const verify::Check& c : checks) {
        CAPTURE(c.name, c.expected, c.got, c.tolerance);
        CHECK(c.passed);
        CHECK(!c.reason.empty());
        CHECK(!c.source.empty());
    }
    REQUIRE(checks.size() >= at_least);
}

}  // namespace

TEST_CASE("two grains led together and apart feel in the core what they feel in LAMMPS",
          "[verify][lammps]") {
    const Scratch scratch("against");
    require_all(verify::led_checks(engines::lammps_program(), scratch.path), 13);
}

TEST_CASE("two grains thrown at one another move in the core as they move in LAMMPS",
          "[verify][lammps]") {
    const Scratch scratch("against");
    require_all(verify::thrown_checks(engines::lammps_program(), scratch.path), 30);
}

// A core that is told another friction by 1 part in 1e4 must be seen to differ; so must one that
// rolls more easily. 1e-6 is the bar of the checks above.
TEST_CASE("a core with slightly other rules does not pass for LAMMPS", "[verify][lammps]") {
    const Scratch scratch("against");
    const engines::TwoGrains right =
        verify::thrown_pair({.name = "right", .angle_deg = 60.0, .spin = 1.0});
    const auto lammps = engines::run_two_grains(engines::lammps_program(), right,
                                                engines::thrown_deck(right), scratch.path);
    engines::TwoGrains wrong = right;
    wrong.contact.sliding_friction *= 1.0001;
    CHECK(verify::apart(verify::thrown_by_core(wrong), lammps, right).force > 1e-5);
    wrong = right;
    wrong.contact.rolling_friction *= 0.99;
    CHECK(verify::apart(verify::thrown_by_core(wrong), lammps, right).torque > 1e-5);
    wrong = right;
    wrong.contact.surface_energy *= 1.001;
    CHECK(verify::apart(verify::thrown_by_core(wrong), lammps, right).velocity > 1e-6);
}

// Each listed difference is there: if LAMMPS or the core took over the other's rule, the list would
// be wrong. 1e-3: far above the 1e-7 that is left where the rules are one.
TEST_CASE("the rules that are listed as different do differ", "[verify][lammps]") {
    const Scratch scratch("against");
    const auto differences = verify::rule_differences(engines::lammps_program(), scratch.path);
    REQUIRE(differences.size() == 8);
    for (const verify::RuleDifference& d : differences) {
        CAPTURE(d.rule, d.size);
        CHECK(d.size > 1e-3);
        CHECK(!d.measure.empty());
    }
}

TEST_CASE("what is not a number is as far apart as can be", "[verify][lammps]") {
    const engines::TwoGrains t = verify::thrown_pair({.name = "", .angle_deg = 40.0});
    const auto good = verify::thrown_by_core(t);
    CHECK(verify::apart(good, good, t).force == 0.0);
    auto bad = good;
    bad[300][1].force.y = std::nan("");
    CHECK_FALSE(verify::apart(bad, good, t).force < 1.0);
    bad = good;
    bad.pop_back();
    CHECK_FALSE(verify::apart(bad, good, t).force < 1.0);
}

// 2000 loose grains in a column of 14 d over a base of 20 d, whose lattice has 316 points inside
// (counted: x, y half-odd, x^2 + y^2 <= 100).
TEST_CASE("a column starts without a contact, and no two seeds alike", "[verify][lammps]") {
    const verify::SlumpPowder powder;
    const engines::Slump a = verify::slump_of(powder, 1), b = verify::slump_of(powder, 2);
    std::size_t loose = 0;
    double closest = 1.0;
    for (std::size_t i = 0; i < a.grains.size(); ++i) {
        loose += !a.grains[i].fixed;
        for (std::size_t j = 0; j < i; ++j)
            if (!a.grains[i].fixed)
                closest =
                    std::min(closest, contact::norm(a.grains[i].position - a.grains[j].position));
    }
    CHECK(loose == 2000);
    CHECK(a.grains.size() - loose == 316);
    CHECK(closest > powder.diameter);
    CHECK(a.grains.back().position.x != b.grains.back().position.x);
    CHECK(a.box.low.z < -2.0 * powder.diameter);
}

TEST_CASE("heaps pass if the interval lies inside the margin, and the control if it does not",
          "[verify][lammps]") {
    verify::HeapRound r{};
    r.lammps = {30.0, 1.0, 10}, r.ours = {30.5, 1.0, 10}, r.control = {26.0, 1.0, 10};
    r.test = statistics::two_one_sided_tests(r.lammps, r.ours, r.margin.angle_deg);
    r.control_test = statistics::two_one_sided_tests(r.lammps, r.control, r.margin.angle_deg);
    auto checks = verify::heap_checks(r);
    CHECK(checks.at(0).passed);
    CHECK(checks.at(1).passed);
    r.ours = {32.0, 1.0, 10};  // 2 deg off: inside, but not its interval
    r.test = statistics::two_one_sided_tests(r.lammps, r.ours, r.margin.angle_deg);
    r.control = {30.0, 1.0, 10};
    r.control_test = statistics::two_one_sided_tests(r.lammps, r.control, r.margin.angle_deg);
    checks = verify::heap_checks(r);
    CHECK_FALSE(checks.at(0).passed);
    CHECK_FALSE(checks.at(1).passed);
    checks = verify::heap_checks({});  // no heaps: nothing is shown
    CHECK_FALSE(checks.at(0).passed);
    CHECK_FALSE(checks.at(1).passed);
}
