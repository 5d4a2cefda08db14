// SPDX-License-Identifier: MIT
#include "diagnose/mismatch.hpp"

#include "diagnose/candidates.hpp"
#include "line.hpp"

#include <catch2/catch.hpp>

using diagnose::Candidate;

namespace {

double p_value(const diagnose::Problem& p, const diagnose::Noise& noise, int draws) {
    const diagnose::Whitener w(p, noise);
    Candidate c{.h = p.hypothesis({}), .fit = {}};
    c.fit = diagnose::fit_base(p, w, c.h);
    const std::vector<diagnose::Term> terms{line::bend()};
    return diagnose::p_of_mismatch(p, w, c.h, c.fit, diagnose::shapes(p, w, c.h, c.fit, terms), {},
                                   1, draws);
}

}  // namespace

// 5 % of 200 is 10; P(fewer than 2 or more than 20) of a binomial is 0.1 %.
TEST_CASE("mismatch: on noise alone a nominal 5 % comes out as 5 %", "[diagnose][mismatch]") {
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
TEST_CASE("mismatch: a bend of six sigma is seen nearly always", "[diagnose][mismatch]") {
    int seen = 0;
    for (unsigned seed = 0; seed < 40; ++seed)
        seen += p_value(line::problem(80, 0.0, 1.0, 0.9, 0.1, 0.0, 500 + seed), {{{0.1, 0.0}}},
                        199) <= 0.05
                    ? 1
                    : 0;
    CHECK(seen >= 37);
}

// Each of twelve recordings bends by 2.4 sigma, n c^2/(5 sigma^2) = 5.8, every other one the other way: no window of one stands out
// and windows of all cancel, yet the 12 x 4 slowest cosines hold 69 more than their mean of 48, 5 of their deviations.
TEST_CASE("mismatch: what each recording shows a little is seen in all", "[diagnose][mismatch]") {
    constexpr int recordings = 12;
    int seen = 0;
    for (unsigned seed = 0; seed < 20; ++seed) {
        diagnose::Problem p = line::problem(80, 0.0, 1.0, 0.06, 0.1, 0.0, 1000 * seed + 700);
        for (unsigned k = 1; k < recordings; ++k) {
            diagnose::Problem other = line::problem(80, 0.0, 1.0, k % 2 == 1 ? -0.06 : 0.06, 0.1,
                                                    0.0, 1000 * seed + 700 + k);
            other.records[0].channels[0].first = p.size;
            p.size += other.size;
            p.recorded.conservativeResize(static_cast<Eigen::Index>(p.size));
            p.recorded.tail(other.recorded.size()) = other.recorded;
            p.records.push_back(std::move(other.records[0]));
        }
        const diagnose::Noise noise(recordings, {{0.1, 0.0}});
        seen += p_value(p, noise, 199) <= 0.05 ? 1 : 0;
    }
    CHECK(seen >= 17);
}
