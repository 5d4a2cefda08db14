// SPDX-License-Identifier: MIT
#include "diagnose/locate.hpp"

#include "diagnose/candidates.hpp"
#include "line.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using diagnose::Candidate;

namespace {

double p_value(const diagnose::Problem& p, const diagnose::Noise& noise, int draws) {
    const diagnose::Whitener w(p, noise);
    Candidate c{.h = p.hypothesis({}), .fit = {}};
    c.fit = diagnose::fit_base(p, w, c.h);
    const std::vector<diagnose::Term> terms{line::bend()};
    return diagnose::test_of_mismatch(p, w, c.h, c.fit, diagnose::shapes(p, w, c.h, c.fit, terms),
                                      {}, 1, draws)
        .p_value;
}

}  // namespace

// 5 % of 200 is 10; P(fewer than 2 or more than 20) of a binomial is 0.1 %.
TEST_CASE("locate: on noise alone a nominal 5 % comes out as 5 %", "[diagnose][locate]") {
    const double rho = GENERATE(0.0, 0.6);
    int alarms = 0;
    for (unsigned seed = 0; seed < 200; ++seed)
        alarms += p_value(line::problem(60, 0.0, 1.0, 0.0, 0.1, rho, 100 + seed), {{{0.1, rho}}},
                          199) <= 0.05
                      ? 1
                      : 0;
    CHECK(alarms >= 2);
    CHECK(alarms <= 20);
}

// lambda = n c^2/(180 sigma^2) = 36: the oracle's power is above 0.999.
TEST_CASE("locate: a bend of six sigma is seen nearly always", "[diagnose][locate]") {
    int seen = 0;
    for (unsigned seed = 0; seed < 40; ++seed)
        seen += p_value(line::problem(80, 0.0, 1.0, 0.9, 0.1, 0.0, 500 + seed), {{{0.1, 0.0}}},
                        199) <= 0.05
                    ? 1
                    : 0;
    CHECK(seen >= 37);
}

// Squares 1 4 4 4 4 1 1 1: 16 of 20 lie in rows 1 to 4.
TEST_CASE("locate: the interval is the shortest that holds 80 % of the squares",
          "[diagnose][locate][exact]") {
    diagnose::Problem p = line::problem(8, 0.0, 0.0, 0.0, 1.0, 0.0, 1);
    Eigen::VectorXd white(8);
    white << 1, -2, -2, -2, -2, 1, 1, 1;
    const auto list = diagnose::located(p, white, 0.001 * white, 0.01);
    REQUIRE(list.size() == 1);
    CHECK(list[0].from == Approx(1.0 / 7.0));
    CHECK(list[0].to == Approx(4.0 / 7.0));
    CHECK(list[0].sign == -1);
    CHECK(list[0].size == Approx(0.002));
}

// z has 6 and 7 of the squares in two recordings, x 9 in one of them.
TEST_CASE(
    "locate: the channel with most of the mismatch comes first, its strongest recording ahead",
    "[diagnose][locate][exact]") {
    diagnose::Problem p = line::problem(4, 0.0, 0.0, 0.0, 1.0, 0.0, 1);
    diagnose::Problem other = line::problem(4, 0.0, 0.0, 0.0, 1.0, 0.0, 2);
    diagnose::Channel x = p.records[0].channels[0];
    x.name = "x", x.first = 4;
    p.records[0].channels.push_back(x);
    other.records[0].channels[0].first = 8;
    p.records.push_back(std::move(other.records[0]));
    p.size = 12;
    Eigen::VectorXd white(12);
    white << 1, 1, 2, 0, 2, 2, 1, 0, 1, 1, 2, 1;
    const auto list = diagnose::located(p, white, white, 0.01);
    REQUIRE(list.size() == 3);
    CHECK(list[0].channel == "z");
    CHECK(list[1].channel == "z");
    CHECK(list[2].channel == "x");
    // By the rms of 80 % of the squares: 1 + 4 + 1 of 7 in the second recording, 1 + 4 of 6 in the first.
    CHECK(list[0].size == Approx(std::sqrt(2.0)));
    CHECK(list[1].size == Approx(std::sqrt(2.5)));
}
