// SPDX-License-Identifier: MIT
// What every law owes, whatever it says: one system of units, exact bits under exact scaling, no
// dead parameter.
#include "tests/contact/rows.hpp"

#include <catch2/catch.hpp>

#include <cmath>

namespace {

// Calls check(label, reference output, scaled output) for every output of every law, the inputs of
// the scaled state being those of the reference after `rescale(value, dimension)`.
template <class Rescale, class Check>
void compare_all_laws(const Rescale& rescale, const Check& check) {
    for (const Row& row : all_laws()) {
        for (const State& state : row.states) {
            State other = state;
            for (Quantity& q : other.inputs) q.value = rescale(q.value, q.dimension);
            const std::vector<Quantity> reference = row.evaluate(state);
            const std::vector<Quantity> scaled = row.evaluate(other);
            for (std::size_t k = 0; k < reference.size(); ++k) {
                INFO(row.law << ": " << reference[k].name);
                check(reference[k], scaled[k]);
            }
        }
    }
}

// `mass`, `length`, `time`: how many times each base quantity doubles.
void require_same_bits(int mass, int length, int time) {
    const auto doubled = [=](double value, Dimension d) {
        return std::ldexp(value, d.mass * mass + d.length * length + d.time * time);
    };
    compare_all_laws(doubled, [&](const Quantity& reference, const Quantity& scaled) {
        REQUIRE(scaled.value == doubled(reference.value, reference.dimension));
    });
}

// Whether ten per cent on input k moves any output by more than 1e-6 of it: far above round-off.
bool matters(const Row& row, const State& state, std::size_t k) {
    State other = state;
    other.inputs[k].value *= 1.1;
    const std::vector<Quantity> before = row.evaluate(state), after = row.evaluate(other);
    for (std::size_t o = 0; o < before.size(); ++o) {
        const double change = std::abs(after[o].value - before[o].value);
        if (change > 1e-6 * std::abs(before[o].value)) return true;
    }
    return false;
}

}  // namespace

// A law that adds metres to kilograms, or hides a number that has a unit, changes its answer with
// the units. The factors are no powers of two. 1e-11: some hundred operations, differences of like
// numbers among them.
TEST_CASE("every law gives the same physics in any units", "[contact][similarity]") {
    const auto in_other_units = [](double value, Dimension d) {
        return value * std::pow(3.7, d.mass) * std::pow(0.21, d.length) * std::pow(5.3, d.time);
    };
    compare_all_laws(in_other_units, [&](const Quantity& reference, const Quantity& scaled) {
        const double expected = in_other_units(reference.value, reference.dimension);
        REQUIRE(scaled.value == Approx(expected).epsilon(1e-11).margin(0.0));
    });
}

// Feng & Owen (2014), doi:10.1007/s40571-014-0010-y: length h, density 1, time h; hence E kept and
// w times h. h = 2^k. No tolerance.
TEST_CASE("exact scaling by a power of two keeps every bit of every law", "[contact][similarity]") {
    const int k = GENERATE(-7, -1, 1, 2, 8);
    require_same_bits(3 * k, k, k);
}

// Gravity and density kept: length h, time sqrt(h); hence E times h and w times h^2. h = 4^k. No
// tolerance.
TEST_CASE("scaling at kept gravity by a power of four keeps every bit of every law",
          "[contact][similarity]") {
    const int k = GENERATE(-3, -1, 1, 4);
    require_same_bits(6 * k, 2 * k, k);
}

TEST_CASE("every parameter of every law matters", "[contact][liveness]") {
    for (const Row& row : all_laws()) {
        for (std::size_t k = 0; k < row.states.front().inputs.size(); ++k) {
            INFO(row.law << ": " << row.states.front().inputs[k].name);
            bool in_some_state = false;
            for (const State& state : row.states)
                in_some_state = in_some_state || matters(row, state, k);
            REQUIRE(in_some_state);
        }
    }
}
