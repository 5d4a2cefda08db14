// SPDX-License-Identifier: MIT
#include "cases/domain.hpp"

#include "cases/messages.hpp"
#include "scaling/errors.hpp"
#include "scaling/nearest_name.hpp"

#include <algorithm>
#include <numbers>

namespace cases {
namespace {

void require(bool holds, const Value& value, const char* rule, const char* remedy) {
    if (!holds) refuse(value, rule, remedy);
}

void check(double x, const Value& value, Domain domain) {
    switch (domain) {
        case Domain::any:
            return;
        case Domain::positive:
            require(x > 0.0, value, "must be > 0",
                    "check the sign, and that the number is not zero");
            return;
        case Domain::not_negative:
            require(x >= 0.0, value, "must be >= 0", "check the sign");
            return;
        case Domain::at_least_one:
            require(x >= 1.0, value, "must be >= 1",
                    "write the larger over the smaller, not the inverse");
            return;
        case Domain::unit_interval:
            require(x >= 0.0 && x <= 1.0, value, "must be between 0 and 1",
                    "write a fraction such as 0.3 or \"30 %\"");
            return;
        case Domain::poisson_ratio:
            require(x > -1.0 && x < 0.5, value, "must be above -1 and below 0.5",
                    "0.5 is incompressible; solids lie between 0.1 and 0.45");
            return;
        case Domain::steepness:
            require(x > -0.5 * std::numbers::pi && x < 0.5 * std::numbers::pi, value,
                    "must be between -90 and 90 deg", "measure the angle from the horizontal");
            return;
    }
}

}  // namespace

double checked(const Value& value, const std::string& unit, Domain domain) {
    if (value.kind == Value::Kind::object)
        refuse(value, "must be a plain value", "write it without value and uncertainty");
    const double x = value.si(parse_unit(unit, value.where));
    check(x, value, domain);
    return x;
}

CheckedPair checked_pair(const Value& value, const std::string& unit, Domain domain) {
    if (value.kind != Value::Kind::object) return {checked(value, unit, domain), 0.0};
    check_keys(value, {"value", "uncertainty"});
    const double x = checked(value.at("value"), unit, domain);
    return {x, value.has("uncertainty")
                   ? checked(value.at("uncertainty"), unit, Domain::not_negative)
                   : 0.0};
}

void check_keys(const Value& object, const std::vector<std::string>& known) {
    if (object.kind != Value::Kind::object)
        refuse(object, "must be an object", "write { } with the keys of docs/case.md");
    for (const auto& [key, member] : object.members) {
        if (std::find(known.begin(), known.end(), key) != known.end()) continue;
        throw scaling::InvalidInput(scaling::mistake(
            member.where, "an unknown key", "must be one of " + scaling::joined(known),
            nearest(key, known).empty() ? "remove it, or correct its name"
                                        : suggestion(key, known)));
    }
}

const std::string& checked_word(const Value& word, const std::vector<std::string>& known) {
    const std::string& text = word.text();
    if (std::find(known.begin(), known.end(), text) == known.end()) {
        refuse(word, "must be one of " + scaling::joined(known),
               nearest(text, known).empty() ? "correct the name" : suggestion(text, known));
    }
    return text;
}

}  // namespace cases
