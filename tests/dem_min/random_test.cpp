// SPDX-License-Identifier: MIT
#include "dem_min/random.hpp"

#include <catch2/catch.hpp>

#include <cstdint>

using dem_min::RandomStream;

namespace {

// The first two 32-bit words of a Philox block as a number on [0, 1): the upper 53 of 64 bits.
double uniform_of(std::uint32_t high, std::uint32_t low) {
    const std::uint64_t bits = (static_cast<std::uint64_t>(high) << 32) | low;
    return static_cast<double>(bits >> 11) / 9007199254740992.0;
}

}  // namespace

// philox4x32 with 10 rounds, file kat_vectors of Random123 1.14 (Salmon et al. 2011): counter and
// key all zero, all ones, and the digits of pi.
TEST_CASE("philox: the published known answers come out", "[dem_min][random][exact]") {
    REQUIRE(RandomStream{0, 0}.uniform(0) == uniform_of(0x6627e8d5, 0xe169c58d));
    REQUIRE(RandomStream{~0ULL, ~0ULL}.uniform(~0ULL) == uniform_of(0x408f276d, 0x41c83b0e));
    // Little end first: counter words 0 and 1 make the index, 2 and 3 the stream.
    REQUIRE(RandomStream{0x299f31d0a4093822, 0x0370734413198a2e}.uniform(0x85a308d3243f6a88) ==
            uniform_of(0xd16cfe09, 0x94fdcceb));
}

TEST_CASE("random: a number does not depend on what was drawn before", "[dem_min][random]") {
    const RandomStream stream{42, 3};
    const double alone = stream.uniform(1000);
    double sum = 0.0;
    for (std::uint64_t k = 0; k < 1000; ++k) sum += stream.uniform(k);
    REQUIRE(stream.uniform(1000) == alone);
    REQUIRE(RandomStream{42, 4}.uniform(1000) != alone);
    REQUIRE(RandomStream{43, 3}.uniform(1000) != alone);
    // Mean of 1000 uniform numbers: 1/2 with a standard deviation of 0.0091; 4 of them.
    REQUIRE(sum / 1000.0 == Approx(0.5).margin(0.037));
}
