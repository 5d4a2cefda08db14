// SPDX-License-Identifier: MIT
// Which values a key may have, and the check.
#pragma once

#include "cases/value.hpp"

#include <string>
#include <vector>

namespace cases {

enum class Domain {
    any,
    positive,
    not_negative,
    at_least_one,
    unit_interval,
    poisson_ratio,
    steepness
};

// The raw SI value of `value`, checked. `unit` is that of the SI value: "m", "rad", "1".
double checked(const Value& value, const std::string& unit, Domain domain);

// Of {"value", "uncertainty"} too: both are checked, and no other key is allowed.
struct CheckedPair {
    double value, uncertainty;
};
CheckedPair checked_pair(const Value& value, const std::string& unit, Domain domain);

// Refuses every key of `object` that is not in `known`, and anything that is no object.
void check_keys(const Value& object, const std::vector<std::string>& known);

// `word`, which must be one of `known`.
const std::string& checked_word(const Value& word, const std::vector<std::string>& known);

}  // namespace cases
