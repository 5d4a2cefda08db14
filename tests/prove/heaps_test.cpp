// SPDX-License-Identifier: MIT
#include "cases/read_case.hpp"
#include "prove/heap_case.hpp"
#include "prove/score.hpp"
#include "tests/prove/lammps.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <sstream>

using namespace prove;

namespace {

constexpr double pi = std::numbers::pi;

// Rings whose height goes with the friction, and one effect that lifts the first ring with its strength: all by hand.
Response straight(const HeapFamily& f) {
    Response r;
    r.base = Eigen::MatrixXd::Zero(feature_count, 3);
    r.base(0, 1) = 1e-3;
    for (const HeapEffect& e : heap_effects(f))
        if (acts_among_grains(e.name)) {
            r.largest[e.name] = e.high;
            r.effects[e.name] = Eigen::MatrixXd::Zero(feature_count, 4);
        }
    r.inverse_covariance = Eigen::MatrixXd::Identity(feature_count, feature_count) / (1e-4 * 1e-4);
    r.spot_scatter = 1e-4;
    return r;
}

}  // namespace

TEST_CASE("heaps: a family of twenty has 8 nulls, 8 singles and 4 that cancel", "[prove][heaps]") {
    std::map<HeapKind, int> kinds;
    std::map<std::string, int> singles;
    for (int number = 1; number <= 100; ++number) {
        const HeapFamily f = heap_family(3, (number - 1) / family_size + 1);
        const HeapPlan p = heap_plan(3, number, f);
        ++kinds[p.kind];
        if (p.kind == HeapKind::single) ++singles[p.effect];
        REQUIRE(p.friction >= f.low);
        REQUIRE(p.friction <= f.high);
        REQUIRE(std::abs(p.start - p.friction) >= 0.1);  // a start is never the truth
    }
    REQUIRE(kinds[HeapKind::null] == 40);
    REQUIRE(kinds[HeapKind::single] == 40);
    REQUIRE(kinds[HeapKind::cancelling] == 20);
    REQUIRE(singles.size() == 6);
    for (const auto& [name, count] : singles) REQUIRE(count >= (name == "polydispersity" ? 2 : 6));
    // Where the user knows of a spread it is none of what is concealed.
    for (const int family : {1, 2}) {
        const HeapFamily f = heap_family(3, family);
        for (const HeapEffect& e : heap_effects(f))
            REQUIRE((e.name != "polydispersity" || f.size_spread == 0.0));
        REQUIRE(with_effect(f, "adhesion", 1.0, 0.5).size_spread == f.size_spread);
    }
}

TEST_CASE("heaps: the scanner sees the highest grain above a spot, and the base beside it",
          "[prove][heaps]") {
    const std::vector<Ball> two{{0.0, 0.0, 1.0, 1.0}, {0.6, 0.0, 3.0, 1.0}};
    REQUIRE(height_above(two, {0.6, 0.0}) == Approx(4.0));
    REQUIRE(height_above(two, {0.8, pi}) == Approx(1.0 + 0.6));  // 3-4-5 on the first
    REQUIRE(height_above(two, {2.0, 0.5 * pi}) == 0.0);
}

TEST_CASE("heaps: first harmonic and rings of a leaning plane are those of its equation",
          "[prove][heaps]") {
    const HeapFamily f = heap_family(1, 1);
    const Arrangement& a = f.arrangements.front();
    std::vector<double> z;
    for (const Spot& s : a.spots)
        z.push_back(2.0 + 0.1 * s.r * std::cos(s.azimuth) - 0.3 * s.r * std::sin(s.azimuth));
    const Eigen::VectorXd features = heap_features(a, z);
    double square = 0.0, weight = 0.0;
    for (std::size_t k = 0; k < spot_radii; ++k)
        square += a.spots[k].r * a.spots[k].r, weight += a.spots[k].r;
    for (Eigen::Index k = 0; k < ring_count; ++k) REQUIRE(features[k] == Approx(2.0));
    REQUIRE(features[ring_count] == Approx(0.1 * square / weight));
    REQUIRE(features[ring_count + 1] == Approx(-0.3 * square / weight));
}

TEST_CASE("heaps: a response is recovered from heaps that follow it", "[prove][heaps]") {
    const HeapFamily f = heap_family(1, 1);
    const std::vector<DesignPour> design = heap_design(1, f, 0);
    std::vector<Eigen::VectorXd> features;
    std::vector<std::vector<double>> heights;
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    constexpr double scatter = 1e-4;
    const auto adhesion = heap_effects(f).front();
    for (const DesignPour& p : design) {
        Eigen::VectorXd v(feature_count);
        for (Eigen::Index k = 0; k < feature_count; ++k) v[k] = scatter * normal(random);
        v[0] += 5e-3 + 2e-3 * std::log(p.friction);
        if (p.effect == "adhesion")
            v[1] += 3e-3 * std::log1p(4.0 * p.strength / adhesion.high) / std::log(5.0);
        features.push_back(v);
        heights.emplace_back(f.arrangements[0].spots.size(), v[0]);
    }
    const Response r = heap_response(f, f.arrangements[0], design, features, heights);
    const Eigen::VectorXd none = mean_features(r, "", 0.0, 0.5, 0.0);
    const Eigen::VectorXd half = mean_features(r, "adhesion", 0.5 * adhesion.high, 0.5, 0.0);
    // Fifteen heaps behind the base, nine behind an effect: no mean is worse than a heap.
    REQUIRE(none[0] == Approx(5e-3 + 2e-3 * std::log(0.5)).margin(scatter));
    REQUIRE(half[1] - none[1] == Approx(3e-3 * std::log(3.0) / std::log(5.0)).margin(3 * scatter));
    // Nine variances of some thirty degrees of freedom each: their mean is known to a tenth; 3 of these.
    const double variance = r.inverse_covariance.inverse().trace() / feature_count;
    REQUIRE(variance == Approx(scatter * scatter).epsilon(0.3));
}

TEST_CASE("heaps: the oracle's figures are those of the quadratic form", "[prove][heaps]") {
    const HeapFamily f = heap_family(1, 1);
    const std::vector<Response> two{straight(f), straight(f)};
    // An offset of all rings; the friction answers in the first alone, wholly.
    const double offset = 3e-4;
    const Oracle o = heap_oracle(f, two, "measurement_offset", offset, 0.4, 0.0);
    const double others = (ring_count - 1) * std::pow(offset / 1e-4, 2);
    REQUIRE(o.lambda == Approx(2 * repeats * others).epsilon(1e-2));  // frictions in 150 steps
    REQUIRE(o.refitted == Approx(0.4 * std::exp(0.3)).epsilon(2e-2));
    REQUIRE(o.d == Approx(std::sqrt(o.lambda)));  // here no other effect does anything
    // What is not there leaves nothing but the step of the frictions.
    REQUIRE(heap_oracle(f, two, "", 0.0, 0.4, 0.0).lambda < 1.0);
}

TEST_CASE("heaps: an effect that does nothing is not told by the scatter of the design",
          "[prove][heaps]") {
    const HeapFamily f = heap_family(1, 1);
    const std::vector<DesignPour> design = heap_design(1, f, 0);
    std::mt19937_64 random(11);
    std::normal_distribution<double> normal;
    constexpr double scatter = 1e-4;
    constexpr int families = 40;
    double as_told = 0.0, as_if_known = 0.0;
    for (int k = 0; k < families; ++k) {
        std::vector<Eigen::VectorXd> features;
        for (std::size_t run = 0; run < design.size(); ++run)
            features.push_back(Eigen::VectorXd::NullaryExpr(
                feature_count, [&] { return scatter * normal(random); }));
        const std::vector<std::vector<double>> heights(
            design.size(), std::vector<double>(f.arrangements[0].spots.size(), 0.0));
        Response r = heap_response(f, f.arrangements[0], design, features, heights);
        const double strength = heap_effects(f).front().high;
        as_told += heap_oracle(f, {r}, "adhesion", strength, 0.4, 0.0).lambda / families;
        r.scatter = 0.0;
        as_if_known += heap_oracle(f, {r}, "adhesion", strength, 0.4, 0.0).lambda / families;
    }
    // Nine numbers of two recordings about means of nine heaps and four coefficients: what is left is what is cut off below 0.
    REQUIRE(as_if_known > 4.0);
    REQUIRE(as_told < 0.3 * as_if_known);
}

TEST_CASE("heaps: what cancels leaves the flank as the user's model has it", "[prove][heaps]") {
    const HeapFamily f = heap_family(1, 1);
    std::vector<Response> three(3, straight(f));
    for (Response& r : three) {
        r.base(1, 1) = 2e-3;
        r.effects["adhesion"](1, 0) = 3e-3, r.effects["rolling_resistance"](1, 0) = 2e-3;
    }
    int seen = 0;
    for (int number = 1; number <= family_size; ++number) {
        const HeapPlan p = heap_plan(5, number, f);
        if (p.kind != HeapKind::cancelling) continue;
        const HeapSecret s = heap_secret(5, p, f, three);
        const Arrangement& fine = f.arrangements.front();
        REQUIRE(s.plan.friction < s.plan.start - 0.09);
        const double told = flank(fine, mean_features(three[0], "", 0.0, s.plan.start, 0.0));
        const double is = flank(
            fine, mean_features(three[0], s.plan.effect, s.plan.strength, s.plan.friction, 0.0));
        REQUIRE(is == Approx(told).margin(0.01));  // half a degree
        ++seen;
    }
    REQUIRE(seen == 4);
}

TEST_CASE("heaps: a case can be read, holds one recording out and does not say what it hides",
          "[prove][heaps]") {
    const HeapFamily f = heap_family(2, 1);
    const std::vector<Response> three(3, straight(f));
    std::set<std::string> skeletons;
    for (const int number : {1, 2, 5}) {
        const HeapSecret s = heap_secret(2, heap_plan(2, number, f), f, three);
        const auto recordings = heap_recordings(2, s.plan, f);
        std::vector<std::vector<double>> rows;
        for (std::size_t k = 0; k < recordings.size(); ++k)
            rows.push_back(recorded(2, s.plan, f.arrangements[recordings[k].arrangement],
                                    std::vector<double>(192, 1e-3), k));
        BlindCase made;
        made.files = heap_files(s.plan, f, recordings, rows);
        made.key = heap_key(s, f, three, rows.back());
        made.key_text = "{}";
        const Folder folder("similitude-heaps-case");
        write(made, folder.path / "cases", folder.path / "keys");
        const cases::Case c =
            cases::read_case((folder.path / "cases" / made.key.name / "case.json").string());
        REQUIRE(c.experiments.size() == 5);
        for (std::size_t k = 0; k < 5; ++k) REQUIRE(c.experiments[k].held_out == (k == 4));
        REQUIRE(c.experiments[0].recording);
        std::string text = made.files.at("case.json");
        // All that differs between cases of a family is the title and where the friction starts.
        for (const std::string& word : {made.key.name, std::string("\"value\": ")})
            for (std::size_t at; (at = text.find(word)) != std::string::npos;)
                text.replace(at, word.size() + (word.front() == '"' ? 5 : 0), "");
        skeletons.insert(text);
    }
    REQUIRE(skeletons.size() == 1);
}

TEST_CASE("heaps: two grains that meet in LAMMPS part with the restitution of the powder",
          "[prove][heaps]") {
    const Folder folder("similitude-heaps-pair");
    for (const double e : {0.3, 0.5, 0.7}) {
        std::ostringstream deck;
        deck << "units si\natom_style sphere\natom_modify map array sort 0 0.0\nnewton off\n"
                "comm_modify vel yes\nboundary f f f\nregion all block -0.01 0.01 -0.01 0.01 -0.01 "
                "0.01 units box\n"
                "create_box 1 all\ncreate_atoms 1 single 0 0 0.0021 units box\n"
                "create_atoms 1 single 0 0 0 units box\nset group all diameter 0.002 density 2500\n"
                "velocity all set 0 0 0 units box\nset atom 1 vz -0.1\npair_style granular\n"
                "pair_coeff * * hertz/material 1e6 "
             << restitution_told(e)
             << " 0.25 damping tsuji tangential mindlin_rescale NULL 1.0 0.5\n"
                "neighbor 0.0005 bin\ntimestep 1e-6\nfix 1 all nve/sphere\nthermo 100000\n"
                "run 20000\nprint \"parted $(vz[1]-vz[2])\"\n";
        const std::string text = run_lammps(folder, {{"deck.in", deck.str()}});
        const std::size_t at = text.rfind("\nparted ");
        REQUIRE(at != std::string::npos);
        // The manual's polynomial is a fit, good to some thousandths.
        CHECK(std::stod(text.substr(at + 8)) / 0.1 == Approx(e).margin(0.01));
    }
}

TEST_CASE("heaps: LAMMPS pours the deck, and what is left rests on the base", "[prove][heaps]") {
    HeapFamily f = heap_family(4, 1, 0.15);
    Pour p{f.arrangements[0].grain, f.arrangements[0].rig,
           with_effect(f, "polydispersity", 0.2, 0.6), 9};
    p.acts.rolling_friction = 0.2, p.acts.tilt_angle = 0.03;
    const Folder folder("similitude-heaps-pour");
    std::map<std::string, std::string> files = lammps_files(p);
    // The fastest grain, every 20 steps.
    std::string& deck = files.at("deck.in");
    for (const auto& [from, to] :
         {std::pair{"thermo 1000000\n",
                    "variable speed atom sqrt(vx*vx+vy*vy+vz*vz)\n"
                    "compute fastest loose reduce max v_speed\nthermo 20\n"},
          std::pair{"c_way c_turn c_top\n", "c_way c_turn c_top c_fastest\n"}}) {
        const std::size_t at = deck.find(from);
        REQUIRE(at != std::string::npos);
        deck.replace(at, std::string(from).size(), to);
    }
    const std::string log = run_lammps(folder, files);
    const std::vector<Ball> heap = heap_in(folder);
    REQUIRE(log.find("given up") == std::string::npos);
    // Who appears within another is kicked: nobody is faster than a fall from where the highest appeared to the box's floor, 4 of the
    // largest diameters below the base, makes.
    std::istringstream lines(log);
    double fastest = 0.0, highest = 0.0;
    int appeared = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("appears ")) {
            const double z = std::stod(line.substr(8));
            REQUIRE(z > p.rig.drop_height);
            highest = std::max(highest, z), ++appeared;
        }
        std::istringstream words(line);
        std::vector<double> row;
        for (double v = 0.0; words >> v;) row.push_back(v);
        if (row.size() == 6 && words.eof()) fastest = std::max(fastest, row[5]);
    }
    // Log-normal with a spread of 0.2, cut at 2.5 deviations: variance log(1 + 0.04) of the logarithm.
    const double largest = std::exp(2.5 * std::sqrt(std::log(1.04)) - 0.5 * std::log(1.04));
    const double fall = highest + 4.0 * largest * p.grain.diameter;
    REQUIRE(appeared == p.rig.grains);
    REQUIRE(highest > p.rig.drop_height + largest * p.grain.diameter);  // some had to be lifted
    REQUIRE(fastest > 0.9 * std::sqrt(2.0 * 9.81 * p.rig.drop_height));
    REQUIRE(fastest < 1.01 * std::sqrt(2.0 * 9.81 * fall));
    REQUIRE(heap.size() > 3);
    REQUIRE(static_cast<int>(heap.size()) <= p.rig.grains);
    const double d = p.grain.diameter;
    for (const Ball& b : heap) {
        REQUIRE(std::hypot(b.x, b.y) < 0.5 * p.rig.base_diameter + d);
        REQUIRE(b.z > -0.5 * d);  // on the glued grains, in their gaps at the deepest
        REQUIRE(b.radius <= 0.5 * d * largest);
        for (const Ball& other : heap) {
            if (&other == &b) continue;
            const double apart = std::hypot(b.x - other.x, b.y - other.y, b.z - other.z);
            // Weight presses soft grains together by (rho g d/E)^(2/3), 1e-3, and a few grains' weight by little more.
            REQUIRE(apart > 0.98 * (b.radius + other.radius));
        }
    }
}

TEST_CASE("heaps: one name on forty nulls is allowed, two are not", "[prove][heaps]") {
    Keys keys;
    Verdicts verdicts;
    for (int k = 0; k < 40; ++k) {
        Key key;
        key.name = case_name(k + 1), key.kind = Kind::null;
        keys[key.name] = key;
        verdicts[key.name] = {.verdict = "consistent"};
    }
    const auto bar = [&] { return heap_score(keys, verdicts).lines.front().met; };
    const Verdict named{.verdict = "explained",
                        .effects = {{.name = "tilt", .probability = 1.0, .named = true}}};
    REQUIRE(bar() == true);
    verdicts[case_name(1)] = named;
    REQUIRE(bar() == true);
    verdicts.erase(case_name(2));  // no verdict counts as a wrong one
    REQUIRE(bar() == false);
}
