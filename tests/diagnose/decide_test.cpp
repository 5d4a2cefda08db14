// SPDX-License-Identifier: MIT
// What counts as an explanation: charged grains over a plate, by Coulomb's law of the image charge.
#include "diagnose/candidates.hpp"
#include "diagnose/catalogue.hpp"
#include "diagnose/diagnose.hpp"
#include "verdicts.hpp"

#include <catch2/catch.hpp>

#include <map>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace {

constexpr double radius = 1e-3, noise = 0.5e-6;  // m, N

// One force curve out of contact for each charge (C), in the order of the list; the model knows of no charge.
diagnose::Verdict verdict_on(const std::vector<double>& charges) {
    std::map<std::string, std::string> files;
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal(0.0, noise);
    std::ostringstream experiments;
    for (std::size_t k = 0; k < charges.size(); ++k) {
        const std::string id = "curve-" + std::to_string(k + 1);
        std::ostringstream table;
        table << "separation [m],force [N],branch\n";
        for (const bool back : {false, true})
            for (int n = 0; n < 60; ++n) {
                const double h = 5e-5 * (back ? n + 1 : 60 - n), apart = 2.0 * (radius + h);
                const double pull = charges[k] * charges[k] /
                                    (4.0 * std::numbers::pi * 8.8541878128e-12 * apart * apart);
                table << h << ',' << -pull + normal(random) << ','
                      << (back ? "retract" : "approach") << '\n';
            }
        files[id + ".csv"] = table.str();
        experiments
            << (k == 0 ? "" : ",") << R"({"id": ")" << id
            << R"(", "rig": "pull_off", "conditions": {"counterpart": "plate", "preload": ")"
            << k + 1 << R"( mN"}, "recording": ")" << id
            << R"(.csv", "noise": {"force": "0.5 uN"}, "role": "fit"})";
    }
    files["case.json"] = R"({"format": "similitude-case/1", "title": "charged",
  "grain": {"diameter": "2 mm", "density": "2500 kg/m^3", "youngs_modulus": "60 GPa", "poisson_ratio": 0.25},
  "plate": {"youngs_modulus": "70 GPa", "poisson_ratio": 0.22},
  "surroundings": {"gravity": "9.81 m/s^2"},
  "model": {"physics": ["hertz_mindlin"], "parameters": {}},
  "experiments": [)" + experiments.str() +
                         "]}\n";
    const cases::Case c = case_of(files);
    return diagnose::diagnose(c, {.seed = 1, .threads = 2}, [](cases::Case&) {});
}

}  // namespace

TEST_CASE("decide: one charge in all recordings is an explanation, one that differs is none",
          "[diagnose]") {
    const diagnose::Verdict same = verdict_on({1e-10, 1e-10});
    CHECK(same.answer == diagnose::Answer::explained);
    CHECK(named(same) == std::vector<std::string>{"electrostatic"});
    const diagnose::Verdict other = verdict_on({1e-10, 1.1e-10});
    INFO(other.summary.front());
    CHECK(other.answer == diagnose::Answer::unexplained);
    CHECK(named(other).empty());
}

TEST_CASE("decide: what is too weak to show is nothing left out", "[diagnose]") {
    const diagnose::Verdict v = verdict_on({0.0, 0.0});
    CHECK(v.answer == diagnose::Answer::consistent);
    REQUIRE_FALSE(v.hypotheses.empty());
    CHECK(v.hypotheses.front().effects.empty());
    // Charges too small to show make up most of its prior range, and count as none.
    CHECK(v.hypotheses.front().probability > 0.6);
}

// Buoyancy and a time step have no parameter of their own, and here the model has none that is free.
TEST_CASE("candidates: two effects without a parameter are a pair like any other", "[diagnose]") {
    std::ostringstream table;
    table << "t [s],z [m]\n";
    for (int k = 0; k < 20; ++k) table << 0.01 * k << ',' << 0.3 - 4.9e-4 * k * k << '\n';
    const std::string bound = R"({"format": "similitude-case/1", "title": "bound",
  "grain": {"diameter": "2 mm", "density": "2500 kg/m^3", "youngs_modulus": "60 MPa", "poisson_ratio": 0.25},
  "plate": {"youngs_modulus": "70 MPa", "poisson_ratio": 0.22},
  "surroundings": {"gravity": "9.81 m/s^2", "fluid_density": "1.2 kg/m^3", "fluid_viscosity": "1.8e-5 Pa*s"},
  "model": {"physics": ["gravity", "hertz_mindlin"],
            "parameters": {"restitution": {"value": 0.6}, "sliding_friction": {"value": 0.3}},
            "numerics": {"time_step": "20 us", "integrator": "verlet"}},
  "experiments": [{"id": "drop", "rig": "drop", "conditions": {"height": "300 mm"}, "recording": "drop.csv",
                   "noise": {"z": "1 mm"}, "role": "fit"}]})";
    const cases::Case c = case_of({{"case.json", bound}, {"drop.csv", table.str()}});
    const diagnose::Problem p = diagnose::problem_of(c);
    const diagnose::Whitener w(p, diagnose::first_guess(p));
    diagnose::Candidate base{.h = p.hypothesis({}), .fit = {}};
    REQUIRE(base.h.unknowns.empty());
    base.fit = diagnose::fit_base(p, w, base.h);
    std::vector<diagnose::Candidate> singles;
    const std::vector<diagnose::Term> terms = diagnose::catalogue(p);
    for (const diagnose::Term& t : terms)
        if (t.unknowns.empty()) singles.push_back(diagnose::extended(p, w, base, t));
    REQUIRE(singles.size() == 2);
    const std::vector<diagnose::Candidate> pairs = diagnose::pairs_of(p, w, singles, 8, 40, 1);
    REQUIRE(pairs.size() == 1);
    CHECK(pairs[0].h.unknowns.empty());
}
