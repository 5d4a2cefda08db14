// SPDX-License-Identifier: MIT
// Bounces on a vibrating plate, worked out here from bounce to bounce; what fits find in them.
#include "diagnose/minima.hpp"

#include "diagnose/candidates.hpp"
#include "diagnose/catalogue.hpp"
#include "diagnose/diagnose.hpp"
#include "diagnose/starts.hpp"
#include "verdicts.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace {

using Eigen::VectorXd;

constexpr double g = 9.81, restitution = 0.7, amplitude = 1.5e-3, frequency = 14.8, phase = 4.85;
constexpr double noise = 2e-3;  // m
constexpr double omega = 2.0 * std::numbers::pi * frequency;

double plate(double t) { return amplitude * std::sin(omega * t + phase); }
double plate_speed(double t) { return amplitude * omega * std::cos(omega * t + phase); }

// Height over the mean of the plate at each time; parabolas between bounces, which are found by bisection.
std::vector<double> heights(double from, const std::vector<double>& times) {
    double t0 = 0.0, z0 = from, v0 = 0.0;
    const auto height = [&](double t) {
        return z0 + v0 * (t - t0) - 0.5 * g * (t - t0) * (t - t0);
    };
    std::vector<double> list;
    constexpr double step = 1e-5;
    double t = 0.0;
    for (const double wanted : times) {
        for (; t < wanted; t += step)
            if (height(t + step) < plate(t + step) && height(t) >= plate(t)) {
                double a = t, b = t + step;
                for (int k = 0; k < 50; ++k) {
                    const double middle = 0.5 * (a + b);
                    (height(middle) >= plate(middle) ? a : b) = middle;
                }
                const double in = v0 - g * (a - t0), up = plate_speed(a);
                z0 = height(a), v0 = up - restitution * (in - up), t0 = a;
            }
        list.push_back(height(wanted));
    }
    return list;
}

// Three drops. `one_wrong`: a value of the first that is set 9 noises off, and its neighbours if asked for.
cases::Case drops(bool one_wrong = false, bool neighbours_wrong = false) {
    std::map<std::string, std::string> files;
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal(0.0, noise);
    std::string experiments;
    for (const int mm : {250, 400, 320}) {
        const std::string id = "drop-" + std::to_string(mm);
        std::vector<double> times;
        for (int k = 0; k < 160; ++k) times.push_back(5.5e-3 * k);  // before it comes to rest
        std::vector<double> z = heights(1e-3 * mm, times);
        for (double& value : z) value += normal(random);
        if (mm == 250 && one_wrong) z[60] += 9.0 * noise;
        if (mm == 250 && neighbours_wrong) z[59] += 9.0 * noise, z[61] += 9.0 * noise;
        std::ostringstream table;
        table << "t [s],z [m]\n";
        for (std::size_t k = 0; k < z.size(); ++k) table << times[k] << ',' << z[k] << '\n';
        files[id + ".csv"] = table.str();
        experiments += (experiments.empty() ? "" : ",") + std::string("{\"id\": \"") + id +
                       R"(", "rig": "drop", "conditions": {"height": ")" + std::to_string(mm) +
                       R"( mm"}, "recording": ")" + id +
                       R"(.csv", "noise": {"z": "2 mm"}, "role": "fit"})";
    }
    files["case.json"] = R"({"format": "similitude-case/1", "title": "on a vibrating plate",
  "grain": {"diameter": "2 mm", "density": "2500 kg/m^3", "youngs_modulus": "60 GPa", "poisson_ratio": 0.25},
  "plate": {"youngs_modulus": "70 GPa", "poisson_ratio": 0.22},
  "surroundings": {"gravity": "9.81 m/s^2", "fluid_density": "1.2 kg/m^3", "fluid_viscosity": "1.8e-5 Pa*s"},
  "model": {"physics": ["gravity", "hertz_mindlin"],
            "parameters": {"restitution": {"value": 0.6, "range": [0.1, 0.99]}, "sliding_friction": {"value": 0.3}}},
  "experiments": [)" + experiments +
                         "]}\n";
    return case_of(files);
}

const diagnose::Term& vibration(const std::vector<diagnose::Term>& terms) {
    const auto found = std::find_if(terms.begin(), terms.end(), [](const diagnose::Term& t) {
        return t.effect == "vibration";
    });
    REQUIRE(found != terms.end());
    return *found;
}

}  // namespace

TEST_CASE(
    "minima: a fit that is led through time comes back to bounces that a fit of all rows at once "
    "loses",
    "[diagnose]") {
    const cases::Case c = drops();
    const diagnose::Problem p = diagnose::problem_of(c);
    const diagnose::Whitener w(p, diagnose::first_guess(p));
    const std::vector<diagnose::Term> terms = diagnose::catalogue(p);
    const diagnose::Term& term = vibration(terms);
    const diagnose::Hypothesised h = diagnose::plus(p, p.hypothesis({}), term);
    VectorXd truth(4);
    truth << restitution, amplitude, frequency, phase;
    REQUIRE(h.unknowns.size() == 4);
    const double at_truth = diagnose::evaluated(p, w, h, truth).objective();
    CHECK(at_truth < 480.0 + 5.0 * std::sqrt(2.0 * 480.0));  // 480 rows of this noise, and no more
    VectorXd away = truth;
    away << restitution - 0.04, 1.1 * amplitude, 1.02 * frequency, phase + 0.4;
    const VectorXd u = diagnose::to_u(h.unknowns, away);
    CHECK(diagnose::descended(p, w, h, u, 40).objective > at_truth + 100.0);
    CHECK(diagnose::followed_in_time(p, w, h, {u}).front().objective <= at_truth);
}

TEST_CASE("minima: a vibration is named among all effects, with its frequency", "[diagnose]") {
    const cases::Case c = drops();
    const diagnose::Verdict v =
        diagnose::diagnose(c, {.seed = 1, .threads = 2}, [](cases::Case&) {});
    REQUIRE(v.answer == diagnose::Answer::explained);
    REQUIRE(v.effects.size() == 1);
    CHECK(v.effects[0].name == "vibration");
    REQUIRE(v.effects[0].parameters.size() == 3);
    CHECK(v.effects[0].parameters[1].name == "frequency");
    CHECK(v.effects[0].parameters[1].value == Approx(frequency).epsilon(2e-3));
}

// Behind a soft cantilever the work of adhesion says at which row a grain lets go: chi squared is a staircase, whose steps a fit that
// follows slopes takes for the floor. Three grains, noise of 25 nN.
TEST_CASE("minima: the work of adhesion is found between the rows of force curves", "[diagnose]") {
    std::map<std::string, std::string> files;
    std::string experiments;
    for (const int um : {33, 67, 70}) {
        std::ostringstream table;
        table << "displacement [um],force [uN],branch\n";
        const double step = 0.0021 * um;
        for (int k = 0; k < 120; ++k) table << step * (58 - k) << ",0,approach\n";
        for (int k = 0; k < 120; ++k) table << step * (k - 61.5) << ",0,retract\n";
        const std::string id = "curve-" + std::to_string(um);
        files[id + ".csv"] = table.str();
        experiments +=
            (experiments.empty() ? "" : ",") + std::string("{\"id\": \"") + id +
            R"(", "rig": "pull_off", "grain": {"diameter": ")" + std::to_string(um) +
            R"( um", "density": "1400 kg/m^3", "youngs_modulus": "4 GPa", "poisson_ratio": 0.35},
            "conditions": {"counterpart": "plate", "preload": "2 uN", "cantilever_stiffness": "2.4 N/m"},
            "noise": {"force": "25 nN"}, "role": "fit", "recording": ")" +
            id + ".csv\"}";
    }
    files["case.json"] = R"({"format": "similitude-case/1",
        "grain": {"diameter": "33 um", "density": "1400 kg/m^3", "youngs_modulus": "4 GPa", "poisson_ratio": 0.35},
        "plate": {"youngs_modulus": "200 GPa", "poisson_ratio": 0.28},
        "model": {"physics": ["hertz_mindlin"], "parameters": {}},
        "experiments": [)" +
                         experiments + "]}";
    const cases::Case c = case_of(files);
    diagnose::Problem p = diagnose::problem_of(c);
    const diagnose::Whitener w(p, diagnose::first_guess(p));
    const std::vector<diagnose::Term> terms = diagnose::catalogue(p);
    const auto adhesion = std::find_if(
        terms.begin(), terms.end(), [](const diagnose::Term& t) { return t.effect == "adhesion"; });
    REQUIRE(adhesion != terms.end());
    const diagnose::Hypothesised h = diagnose::plus(p, p.hypothesis({}), *adhesion);
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal(0.0, 25e-9);
    for (int n = 0; n < 24; ++n) {
        const double truth = 0.01 * std::pow(5.0, n / 24.0);
        VectorXd theta = diagnose::start_of(h.unknowns);
        theta[theta.size() - 1] = truth;
        p.recorded = diagnose::predicted(p, h, theta);
        for (double& value : p.recorded) value += normal(random);
        for (diagnose::Record& r : p.records)
            for (diagnose::Channel& ch : r.channels)
                for (std::size_t k = 0; k < ch.recorded.size(); ++k)
                    ch.recorded[k] = p.recorded[static_cast<Eigen::Index>(ch.first + k)];
        diagnose::Candidate base{.h = p.hypothesis({}), .fit = {}};
        base.fit = diagnose::fit_base(p, w, base.h);
        diagnose::Candidate found = diagnose::extended(p, w, base, *adhesion);
        diagnose::deepen(p, w, found, &base);
        INFO(truth);
        // A step is worth hundreds; 1 is what an end of a fit may differ by.
        CHECK(found.fit.objective() < diagnose::fit(p, w, h, theta, false).objective() + 1.0);
    }
}

TEST_CASE("minima: an angle of a full turn has no ends", "[diagnose]") {
    const cases::Case c = drops();
    const diagnose::Problem p = diagnose::problem_of(c);
    const std::vector<diagnose::Term> terms = diagnose::catalogue(p);
    const diagnose::Term& term = vibration(terms);
    VectorXd theta(3);
    theta << 1e-3, 20.0, -0.5;
    const VectorXd back = diagnose::to_theta(term.unknowns, diagnose::to_u(term.unknowns, theta));
    CHECK(back[2] == Approx(2.0 * std::numbers::pi - 0.5));
}

TEST_CASE("outliers: one value gone wrong is set aside and told, three neighbours are not",
          "[diagnose]") {
    const auto told = [](const cases::Case& c) {
        int times = 0;
        const diagnose::Verdict v =
            diagnose::diagnose(c, {.seed = 1, .threads = 2}, [](cases::Case&) {});
        for (const std::string& words : v.warnings)
            times += words.find("set aside") != std::string::npos &&
                     words.find("drop-250") != std::string::npos;
        return times;
    };
    CHECK(told(drops()) == 0);
    CHECK(told(drops(true)) == 1);
    CHECK(told(drops(true, true)) == 0);
}
