// SPDX-License-Identifier: MIT
// One value of a case as it was written, with the place where it stands, free of the file format
// that it came from. Every accessor throws scaling::InvalidInput in the one-line shape of
// scaling::mistake: place, value, rule, remedy.
#pragma once

#include "cases/units.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace cases {

struct Value {
    enum class Kind { null, boolean, number, text, list, object };

    std::string where{};  // "powder/case.json: grain.diameter"
    Kind kind = Kind::object;
    double written_number = 0.0;  // Kind::number as written, Kind::boolean 0 or 1
    std::string written_text{};   // Kind::text as written
    std::vector<Value> items{};   // Kind::list
    std::vector<std::pair<std::string, Value>> members{};  // Kind::object, in the order of the file

    bool has(const std::string& key) const;
    const Value& at(const std::string& key) const;  // throws where the key is missing

    // A dimensionless number, bare or in per cent ("30 %"); of {"value", "uncertainty"} the value.
    double number() const;
    std::int64_t count() const;  // a whole number >= 1
    const std::string& text() const;
    bool boolean() const;

    // "1.2 um"; of {"value", "uncertainty"} the value. An angle is a Dimensionless in rad: "5 deg".
    template <class Q>
    Q quantity() const {
        return Q::from_value(si(scaling::dimension_of<Q>()));
    }
    // The same, or `otherwise` where this object has no such key.
    template <class Q>
    Q quantity_or(const std::string& key, Q otherwise) const {
        return has(key) ? at(key).quantity<Q>() : otherwise;
    }
    // Standard deviation of {"value", "uncertainty"}; 0 where none is given.
    template <class Q>
    Q uncertainty() const {
        return Q::from_value(si_uncertainty(scaling::dimension_of<Q>()));
    }

    // The same in raw SI, where the dimension is known at run time only.
    double si(const scaling::Dimension& expected) const;
    double si(const Unit& expected) const;
    double si_uncertainty(const scaling::Dimension& expected) const;
    double si_uncertainty(const Unit& expected) const;

    std::string as_written() const;  // for messages: "\"-4 mm\"", "0.3", "a list of 2"
};

// The mistake at this value: `rule` begins with "must", `remedy` says what to write instead.
[[noreturn]] void refuse(const Value&, const std::string& rule, const std::string& remedy);

}  // namespace cases
