// SPDX-License-Identifier: MIT
// The user's own run is one of LAMMPS (data/lammps-bounce/SOURCE.txt), once resolved and once in steps that are too long.
#include "diagnose/own_run.hpp"

#include "cases/read_case.hpp"
#include "diagnose/diagnose.hpp"

#include <catch2/catch.hpp>

#include <random>
#include <string>
#include <vector>

namespace {

constexpr double noise = 2e-4;  // m, as the cases state it

cases::Case recorded(const std::string& file) {
    cases::Case c = cases::read_case("tests/diagnose/data/lammps-bounce/" + file);
    std::mt19937_64 random(11);
    std::normal_distribution<double> normal(0.0, noise);
    for (cases::Experiment& e : c.experiments)
        for (cases::Column& column : e.recording->columns)
            if (column.name == "z")
                for (double& z : column.values) z += normal(random);
    return c;
}

diagnose::Verdict verdict_on(const cases::Case& c) {
    return diagnose::diagnose(c, {.seed = 1, .threads = 2}, [](cases::Case&) {});
}

}  // namespace

TEST_CASE("own run: this tool reproduces a resolved bounce of LAMMPS", "[diagnose][own_run]") {
    const cases::Case c = recorded("case.json");
    const diagnose::Problem p = diagnose::problem_of(c);
    for (const diagnose::Record& r : p.records)
        for (const diagnose::Channel& channel : r.channels) {
            REQUIRE(channel.own_run_rms);
            // The restitution e of those runs is stated to 5e-4 or so: the top of the first bounce is off by 2 e h of that.
            const double h = r.experiment->id == "bounce-30" ? 0.03 : 0.06;
            CHECK(*channel.own_run_rms < 2.0 * 0.573 * h * 5e-4);
            CHECK(channel.own_run_off.empty());
        }
    const diagnose::Verdict v = verdict_on(c);
    CHECK(v.answer == diagnose::Answer::consistent);
    CHECK(v.warnings.front().find("which these recordings cannot show") != std::string::npos);
}

TEST_CASE("own run: steps that are too long are named as what they are", "[diagnose][own_run]") {
    const diagnose::Verdict v = verdict_on(recorded("too-long.json"));
    CHECK(v.answer == diagnose::Answer::explained);
    REQUIRE(v.effects.size() == 1);
    CHECK(v.effects.front().name == "numerical_artefact");
    CHECK(v.effects.front().named);
}

TEST_CASE("own run: what a run has and this tool has not goes with the artefact alone",
          "[diagnose][own_run]") {
    cases::Case c = recorded("case.json");
    // As if the user's engine had lost 2 mm from 0.3 s on.
    for (cases::Experiment& e : c.experiments) {
        const std::vector<double> t = e.simulated->values("t");
        for (cases::Column& column : e.simulated->columns)
            if (column.name == "z")
                for (std::size_t k = 0; k < t.size(); ++k)
                    if (t[k] > 0.3) column.values[k] -= 2e-3;
    }
    const diagnose::Problem p = diagnose::problem_of(c);
    for (const diagnose::Record& r : p.records) REQUIRE(!r.channels.front().own_run_off.empty());
    const diagnose::Verdict v = verdict_on(c);
    CHECK(v.answer == diagnose::Answer::explained);
    CHECK(v.effects.front().name == "numerical_artefact");
}
