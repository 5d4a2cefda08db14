// SPDX-License-Identifier: MIT
// One check: what should come out, what came out, how far the two may lie apart and why.
#pragma once

#include <cmath>
#include <string>
#include <utility>

namespace verify {

struct Check {
    std::string
        name;  // a sentence: "two spheres without adhesion part with the restitution asked for"
    std::string group;  // subject: "impact", "adhesion", ...
    double expected = 0.0, got = 0.0;
    std::string unit;        // SI; "1" where there is none
    double tolerance = 0.0;  // of |got - expected|, over |expected| if `relative`
    bool relative = true;
    std::string reason;  // why the tolerance is what it is
    bool passed = false;
    std::string source;  // where the expected value comes from
};

// What a check is about; the numbers come in with the two functions below.
struct Claim {
    std::string name, group, unit, reason, source;
};

// Passes if |got - expected| <= tolerance |expected|; never if `got` is not a number.
inline Check check_relative(Claim c, double expected, double got, double tolerance) {
    const bool passed = std::abs(got - expected) <= tolerance * std::abs(expected);
    return {std::move(c.name),
            std::move(c.group),
            expected,
            got,
            std::move(c.unit),
            tolerance,
            true,
            std::move(c.reason),
            passed,
            std::move(c.source)};
}

// Passes if |got - expected| <= tolerance, which is in the unit of the claim.
inline Check check_absolute(Claim c, double expected, double got, double tolerance) {
    const bool passed = std::abs(got - expected) <= tolerance;
    return {std::move(c.name),
            std::move(c.group),
            expected,
            got,
            std::move(c.unit),
            tolerance,
            false,
            std::move(c.reason),
            passed,
            std::move(c.source)};
}

}  // namespace verify
