// SPDX-License-Identifier: MIT
// Steps of the judge, each by itself.
#include "diagnose/judge.hpp"

#include "diagnose/catalogue.hpp"
#include "rolled.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <memory>
#include <numbers>

// The plane leans by a degree and the ruler begins 3 mm late. No pair has been tried before, as where the beam missed the right one.
TEST_CASE("judge: the second search finds a pair that the first has missed", "[diagnose]") {
    const cases::Case c = rolled(std::numbers::pi / 180.0, [](double) { return 3e-3; });
    const diagnose::Settings settings{.seed = 1, .threads = 2};
    diagnose::Judge j(c, settings, nullptr);
    j.terms = diagnose::catalogue(j.problem);
    j.noise = diagnose::first_guess(j.problem);
    j.whiten = std::make_unique<diagnose::Whitener>(j.problem, j.noise);
    j.fit_base();
    j.fit_singles();
    constexpr double rows = 180.0;
    for (const diagnose::Candidate& single : j.singles)
        CHECK(single.fit.chi_squared > 2.0 * rows);  // no one effect does
    REQUIRE(j.pairs.empty());
    j.search_pairs_again();
    const auto best = std::max_element(
        j.pairs.begin(), j.pairs.end(),
        [](const auto& a, const auto& b) { return a.log_evidence < b.log_evidence; });
    REQUIRE(best != j.pairs.end());
    std::vector<std::string> names;
    for (const diagnose::Term* t : best->h.terms) names.push_back(t->effect);
    std::sort(names.begin(), names.end());
    CHECK(names == std::vector<std::string>{"measurement_offset", "tilt"});
    // chi^2 of 180 rows: 180 +- 19, three deviations.
    CHECK(best->fit.chi_squared == Approx(rows).margin(3.0 * 19.0));
}
