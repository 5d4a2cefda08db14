// SPDX-License-Identifier: MIT
// What stands in a case beside its recordings must not tell whether something is concealed: the nearest neighbour in the space
// of the metadata is as often of the other kind.
#include "prove/campaign.hpp"
#include "prove/score.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace prove;

namespace {

// As written in the case: sizes, materials, conditions, sampling, noise, what the model lists, what is free.
std::vector<double> features(const BlindCase& blind) {
    const Skeleton& sk = blind.skeleton;
    const Setup &s = sk.stated.front(), &last = sk.stated.back();
    std::vector<double> f{std::log(s.diameter),
                          std::log(s.density),
                          std::log(s.youngs_modulus),
                          s.fluid_density,
                          s.gravity,
                          std::log(s.height + 1e-3),
                          std::log(std::abs(s.speed) + 1e-2),
                          s.angle,
                          std::log(last.diameter / s.diameter),
                          std::log((last.height + 1e-3) / (s.height + 1e-3)),
                          std::log(s.noise.front()),
                          static_cast<double>(sk.stated.size()),
                          static_cast<double>(s.at.size()),
                          static_cast<double>(s.recorded.size()),
                          static_cast<double>(sk.physics.size()),
                          static_cast<double>(sk.nuisances.size()),
                          static_cast<double>(s.rig) * 3.0,
                          sk.states_noise ? 1.0 : 0.0,
                          sk.states_numerics ? 1.0 : 0.0};
    for (const char* effect :
         {"air_drag", "buoyancy", "adhesion", "rolling_resistance", "hertz_coulomb"})
        f.push_back(std::count(sk.physics.begin(), sk.physics.end(), effect) > 0 ? 1.0 : 0.0);
    double free = 0.0;
    for (const Stated& p : sk.parameters) free += p.free ? 1.0 : 0.0;
    f.push_back(free);
    return f;
}

void standardise(std::vector<std::vector<double>>& rows) {
    for (std::size_t c = 0; c < rows.front().size(); ++c) {
        double mean = 0.0, squares = 0.0;
        for (const auto& r : rows) mean += r[c] / static_cast<double>(rows.size());
        for (const auto& r : rows) squares += (r[c] - mean) * (r[c] - mean);
        const double spread = std::sqrt(squares / static_cast<double>(rows.size()));
        for (auto& r : rows) r[c] = spread > 0.0 ? (r[c] - mean) / spread : 0.0;
    }
}

}  // namespace

TEST_CASE("prove: metadata do not tell a null from a concealed effect", "[prove]") {
    std::vector<std::vector<double>> rows;
    std::vector<bool> null;
    int nulls = 0, others = 0;
    for (int number = 1; nulls < 60 || others < 60; ++number) {
        const Kind kind = plan(5, number).kind;
        if (kind != Kind::null && kind != Kind::single) continue;
        int& count = kind == Kind::null ? nulls : others;
        if (count >= 60) continue;
        ++count;
        rows.push_back(features(make_case(5, number, Figures::none)));
        null.push_back(kind == Kind::null);
    }
    standardise(rows);
    int right = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        double least = std::numeric_limits<double>::infinity();
        bool neighbour = false;
        for (std::size_t k = 0; k < rows.size(); ++k) {
            if (k == i) continue;
            double d = 0.0;
            for (std::size_t c = 0; c < rows[i].size(); ++c)
                d += (rows[i][c] - rows[k][c]) * (rows[i][c] - rows[k][c]);
            if (d < least) least = d, neighbour = null[k];
        }
        right += neighbour == null[i] ? 1 : 0;
    }
    // Chance is a half, and Wilson's interval of 120 cases is a tenth to either side.
    const Wilson w = wilson(right, static_cast<int>(rows.size()));
    INFO(right << " of " << rows.size());
    REQUIRE(w.low <= 0.5);
}
