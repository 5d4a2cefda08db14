// SPDX-License-Identifier: MIT
#include "cases/value.hpp"

#include "cases/messages.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cases {
namespace {

const Value* find(const Value& value, const std::string& key) {
    const auto found = std::find_if(value.members.begin(), value.members.end(),
                                    [&](const auto& m) { return m.first == key; });
    return found == value.members.end() ? nullptr : &found->second;
}

// Raw SI of text or number; `Expected` is a Unit or a Dimension.
template <class Expected>
double si_of(const Value& value, const Expected& expected, bool pure) {
    switch (value.kind) {
        case Value::Kind::object:
            return value.at("value").si(expected);
        case Value::Kind::text:
            return to_si(value.written_text, expected, value.where);
        case Value::Kind::number:
            if (!pure) refuse_bare(value.written_number, expected, value.where);
            return value.written_number;
        default:
            refuse(value, "must be a number with its unit", "write a string such as \"1.2 um\"");
    }
}

}  // namespace

bool Value::has(const std::string& key) const { return find(*this, key) != nullptr; }

const Value& Value::at(const std::string& key) const {
    if (const Value* member = find(*this, key)) return *member;
    const bool top = where.ends_with(": ") || where.empty();
    throw scaling::InvalidInput(scaling::mistake(where + (top ? "" : ".") + key, "nothing",
                                                 "must be given", "add the key \"" + key + "\""));
}

double Value::number() const {
    static const Unit one = parse_unit("1", "");
    return si(one);
}

std::int64_t Value::count() const {
    constexpr double largest = 9007199254740992.0;  // 2^53: above it a double skips whole numbers
    const double n = kind == Kind::number ? written_number : 0.0;
    if (n < 1.0 || n > largest || n != std::floor(n)) {
        refuse(*this, "must be a whole number >= 1", "write a bare number such as 1300");
    }
    return static_cast<std::int64_t>(n);
}

const std::string& Value::text() const {
    if (kind != Kind::text) refuse(*this, "must be text", "write it in quotes");
    return written_text;
}

bool Value::boolean() const {
    if (kind != Kind::boolean)
        refuse(*this, "must be true or false", "write true or false without quotes");
    return written_number != 0.0;
}

double Value::si(const scaling::Dimension& expected) const {
    return si_of(*this, expected, expected.dimensionless());
}

double Value::si(const Unit& expected) const {
    const bool pure = expected.dimension.dimensionless() && scaling::is_zero(expected.current);
    return si_of(*this, expected, pure && scaling::is_zero(expected.angle));
}

double Value::si_uncertainty(const scaling::Dimension& expected) const {
    return kind == Kind::object && has("uncertainty") ? at("uncertainty").si(expected) : 0.0;
}

double Value::si_uncertainty(const Unit& expected) const {
    return kind == Kind::object && has("uncertainty") ? at("uncertainty").si(expected) : 0.0;
}

std::string Value::as_written() const {
    switch (kind) {
        case Kind::null:
            return "null";
        case Kind::boolean:
            return written_number != 0.0 ? "true" : "false";
        case Kind::number:
            return fmt::format("{}", written_number);
        case Kind::text:
            return in_quotes(written_text);
        case Kind::list:
            return fmt::format("a list of {}", items.size());
        case Kind::object:
            return has("value") ? at("value").as_written()
                                : fmt::format("an object of {} keys", members.size());
    }
    return "";
}

void refuse(const Value& value, const std::string& rule, const std::string& remedy) {
    throw scaling::InvalidInput(scaling::mistake(value.where, value.as_written(), rule, remedy));
}

}  // namespace cases
