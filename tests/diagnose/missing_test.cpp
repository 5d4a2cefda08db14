// SPDX-License-Identifier: MIT
// What no catalogue has, by closed forms: a restitution that falls with the angle of the way in, where rigid friction slides
// throughout or leaves rolling (Walton 1993), and a camera that settles while spheres roll down a plane.
#include "diagnose/diagnose.hpp"
#include "rolled.hpp"
#include "verdicts.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <random>
#include <sstream>
#include <string>

namespace {

constexpr double noise = 0.003, e0 = 0.85, mu = 0.12;

// Restitution e0 (1 - loss sin^2 angle), thrown with 2 and with 4 m/s.
diagnose::Verdict verdict_on(double loss) {
    std::map<std::string, std::string> files;
    std::mt19937_64 random(8);
    std::normal_distribution<double> normal(0.0, noise);
    std::string experiments;
    for (const char* speed : {"2", "4"}) {
        std::ostringstream table;
        table << "angle [deg],normal_restitution [1],tangential_restitution [1]\n";
        for (int degrees = 4; degrees <= 80; degrees += 2) {
            const double angle = degrees * std::numbers::pi / 180.0;
            const double e = e0 * (1.0 - loss * std::pow(std::sin(angle), 2));
            const double kept = std::max(5.0 / 7.0, 1.0 - mu * (1.0 + e) / std::tan(angle));
            table << degrees << ',' << e + normal(random) << ',' << kept + normal(random) << '\n';
        }
        const std::string id = std::string("thrown-") + speed;
        files[id + ".csv"] = table.str();
        if (!experiments.empty()) experiments += ',';
        experiments += R"({"id": ")" + id + R"(", "rig": "impact", "conditions": {"speed": ")" +
                       speed + R"( m/s"}, "recording": ")" + id +
                       R"(.csv", "noise": {"normal_restitution": 0.003,
                       "tangential_restitution": 0.003}, "role": "fit"})";
    }
    files["case.json"] = R"({"format": "similitude-case/1", "title": "thrown",
  "grain": {"diameter": "4 mm", "density": "2500 kg/m^3", "youngs_modulus": "60 GPa", "poisson_ratio": 0.22},
  "plate": {"youngs_modulus": "60 GPa", "poisson_ratio": 0.22},
  "surroundings": {"gravity": "9.81 m/s^2"},
  "model": {"physics": ["hertz_coulomb"], "parameters": {"restitution": {"value": 0.7, "range": [0.4, 0.99]},
            "sliding_friction": {"value": 0.2, "range": [0.05, 0.5]}}},
  "experiments": [)" + experiments +
                         "]}\n";
    return diagnose::diagnose(case_of(files), {.seed = 1, .threads = 2}, [](cases::Case&) {});
}

}  // namespace

TEST_CASE("missing: a restitution that falls with the angle is in no catalogue, but is seen",
          "[diagnose]") {
    constexpr double loss = 0.2;
    const diagnose::Verdict v = verdict_on(loss);
    CHECK(v.answer == diagnose::Answer::unexplained);
    CHECK(named(v).empty());
    REQUIRE(v.effects.front().missing);
    const diagnose::MissingEstimate& m = *v.effects.front().missing;
    CHECK(m.variable == "impact_angle");
    CHECK(m.of == diagnose::Missing::restitution);
    CHECK(m.unit == "rad");
    CHECK(m.words.find("a rebound") != std::string::npos);
    // The free restitution makes up for one factor on all, so knots are compared with the third; those at the ends have half as many
    // values. Straight between knots 18 deg apart a parabola of curvature 2 loss is off by at most loss (0.31 rad)^2/4 = 0.005;
    // three errors of a knot that some eight values tell are 0.004.
    const auto truth = [&](double angle) { return 1.0 - loss * std::pow(std::sin(angle), 2); };
    for (const std::size_t k : {1U, 3U, 4U})
        CHECK((1.0 + m.values[k]) / (1.0 + m.values[2]) ==
              Approx(truth(m.knots[k]) / truth(m.knots[2])).margin(0.01));
}

TEST_CASE("missing: where the restitution is one number nothing is missing", "[diagnose]") {
    CHECK(verdict_on(0.0).answer == diagnose::Answer::consistent);
}

namespace {

constexpr double slow = 0.05, settled = 5e-3;  // s, m

// Of s, as recorded: what a camera that settles adds.
double settling(double t) { return settled * std::log1p(t / slow) / std::log1p(1.0 / slow); }

diagnose::Verdict rolling_verdict(double share) {
    const cases::Case c = rolled(0.0, [&](double t) { return share * settling(t); });
    return diagnose::diagnose(c, {.seed = 1, .threads = 2}, [](cases::Case&) {});
}

}  // namespace

TEST_CASE("missing: a reading that settles is told as a drift", "[diagnose]") {
    const diagnose::Verdict v = rolling_verdict(1.0);
    CHECK(v.answer == diagnose::Answer::unexplained);
    CHECK(named(v).empty());
    REQUIRE(v.effects.front().missing);
    const diagnose::MissingEstimate& m = *v.effects.front().missing;
    REQUIRE(m.of == diagnose::Missing::drift);
    CHECK(m.channel == "s");
    CHECK(m.variable == "t");
    CHECK(m.unit_of_values == "m");
    CHECK(m.words.find("a reading of s") != std::string::npos);
    // Straight between knots 61 ms apart the logarithm is off by at most settled (61 ms)^2/8/(70 ms)^2/log(21) = 0.16 mm; three
    // errors of a knot that some ten rows of each recording tell are 0.16 mm.
    for (std::size_t k = 2; k < m.knots.size(); ++k)
        CHECK(m.values[k] == Approx(settling(m.knots[k])).margin(0.32e-3));
}

TEST_CASE("missing: where no reading drifts nothing is missing", "[diagnose]") {
    CHECK(rolling_verdict(0.0).answer == diagnose::Answer::consistent);
}
