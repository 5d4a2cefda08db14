// SPDX-License-Identifier: MIT
#include "cases/units.hpp"

#include "cases/messages.hpp"
#include "cases/unit_text.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

namespace cases {
namespace {

// What a dimension is called and how it is written, for messages. Of several names the first stands
// for the dimension.
struct Spoken {
    const char* unit;
    const char* name;
};
constexpr std::array<Spoken, 21> spoken{{{"m", "a length"},
                                         {"s", "a time"},
                                         {"kg", "a mass"},
                                         {"m^2", "an area"},
                                         {"m^3", "a volume"},
                                         {"kg/m^3", "a density"},
                                         {"m/s", "a velocity"},
                                         {"m/s^2", "an acceleration"},
                                         {"N", "a force"},
                                         {"Pa", "a pressure or modulus"},
                                         {"J", "an energy"},
                                         {"J/m^2", "an energy per area"},
                                         {"Pa*s", "a viscosity"},
                                         {"kg/s", "a mass per time"},
                                         {"rad/s", "a spin"},
                                         {"Hz", "a frequency"},
                                         {"1/s", "a rate"},
                                         {"rad", "an angle"},
                                         {"C", "a charge"},
                                         {"(s/m)^(1/5)", "a loss coefficient"},
                                         {"1", "a dimensionless number"}}};

// Units worth suggesting for one that is not known.
const std::vector<std::string>& common_units() {
    static const std::vector<std::string> units{
        "m",   "mm",   "um",  "nm",     "cm",     "kg",   "g",    "mg",    "ug",   "s",
        "ms",  "us",   "min", "N",      "mN",     "uN",   "nN",   "kN",    "Pa",   "kPa",
        "MPa", "GPa",  "J",   "mJ",     "uJ",     "nJ",   "Pa*s", "mPa*s", "cP",   "deg",
        "rad", "rpm",  "Hz",  "J/m^2",  "N/m",    "N/mm", "m/s",  "m/s^2", "mm/s", "rad/s",
        "1/s", "kg/s", "g/s", "kg/m^3", "g/cm^3", "m^2",  "m^3",  "ml",    "ul",   "%",
        "C",   "pC",   "bar", "dyn/cm", "mJ/m^2"};
    return units;
}

bool same_dimension(const Unit& a, const Unit& b) {
    return a.dimension == b.dimension && a.current == b.current;
}

std::string exponents(const Unit& unit) {
    std::string text = scaling::to_string(unit.dimension);
    if (scaling::is_zero(unit.current)) return text;
    if (text == "1") text.clear();
    return text + (text.empty() ? "I" : " I") +
           (unit.current == scaling::Rational(1) ? "" : "^" + scaling::to_string(unit.current));
}

// The expected unit as messages speak of it: "a spin" in "rad/s".
struct Wanted {
    std::string name, unit;
};

Wanted wanted(const Unit& expected) {
    for (const Spoken& s : spoken) {
        if (expected.text == s.unit) return {s.name, s.unit};
    }
    for (const Spoken& s : spoken) {
        if (same_dimension(parse_normalised_unit(s.unit), expected)) return {s.name, s.unit};
    }
    return {"a quantity", expected.text.empty() ? "SI units of this dimension" : expected.text};
}

// A value split at the end of its number.
struct Written {
    double number;
    std::string number_text, unit_text;
};

[[noreturn]] void refuse(const std::string& where, const std::string& got, const std::string& rule,
                         const std::string& remedy) {
    throw scaling::InvalidInput(scaling::mistake(where, got, rule, remedy));
}

// "x 10^-7" or "*10^-7" behind a number, as papers print it; moves `at` behind it.
int power_of_ten(const std::string& text, std::size_t& at) {
    std::size_t i = text.find_first_not_of(' ', at);
    if (i == std::string::npos || (text[i] != 'x' && text[i] != '*')) return 0;
    i = text.find_first_not_of(' ', i + 1);
    if (i == std::string::npos || text.compare(i, 3, "10^") != 0) return 0;
    int exponent = 0;
    const auto [end, error] =
        std::from_chars(text.data() + i + 3, text.data() + text.size(), exponent);
    if (error != std::errc{}) return 0;
    at = static_cast<std::size_t>(end - text.data());
    return exponent;
}

Written split(const std::string& text, const std::string& where) {
    const std::string plain = normalise(text);
    const std::size_t from = plain.starts_with('+') ? 1 : 0;
    double number = 0.0;
    const auto [end, error] =
        std::from_chars(plain.data() + from, plain.data() + plain.size(), number);
    if (error != std::errc{} || !std::isfinite(number)) {
        refuse(where, in_quotes(text), "must begin with a finite number",
               "write a number and its unit, such as \"1.2 um\"");
    }
    auto at = static_cast<std::size_t>(end - plain.data());
    if (at + 1 < plain.size() && plain[at] == ',' &&
        std::isdigit(static_cast<unsigned char>(plain[at + 1])) != 0) {
        refuse(where, in_quotes(text), "must have a decimal point and no thousands separator",
               "write 1.2 for one and a fifth, 1200 for twelve hundred");
    }
    if (const int exponent = power_of_ten(plain, at); exponent != 0) {
        const std::string scientific =
            fmt::format("{}e{}", std::string_view(plain.data() + from, end), exponent);
        std::from_chars(scientific.data(), scientific.data() + scientific.size(), number);
    }
    const std::size_t unit = plain.find_first_not_of(' ', at);
    std::string unit_text = unit == std::string::npos ? "" : plain.substr(unit);
    if (unit_text.size() > 1 && unit_text.front() == '[' && unit_text.back() == ']') {
        unit_text = unit_text.substr(1, unit_text.size() - 2);
    }
    return {number, plain.substr(0, at), unit_text};
}

bool readable_as(const std::string& unit_text, const Unit& expected) {
    try {
        return same_dimension(parse_normalised_unit(unit_text), expected);
    } catch (const UnitProblem&) {
        return false;
    }
}

// A near miss of the right dimension: one power changed or added ("J/m^3" for "J/m^2"), or "" where there is none.
std::string respelled(const std::string& unit_text, const Unit& expected) {
    for (std::size_t i = 0; i < unit_text.size(); ++i) {
        const auto c = static_cast<unsigned char>(unit_text[i]);
        const bool symbol_ends = std::isalpha(c) != 0 &&
                                 (i + 1 == unit_text.size() ||
                                  std::isalnum(static_cast<unsigned char>(unit_text[i + 1])) == 0);
        for (const char digit : {'2', '3', '1'}) {
            std::string candidate = unit_text;
            if (std::isdigit(c) != 0) {
                candidate[i] = digit;
            } else if (symbol_ends) {
                candidate.insert(i + 1, std::string("^") + digit);
            } else {
                break;
            }
            if (readable_as(candidate, expected)) return candidate;
        }
    }
    return "";
}

std::string example(const std::string& number, const std::string& unit) {
    return in_quotes(unit == "1" ? number : number + " " + (unit == "rad" ? "deg" : unit));
}

[[noreturn]] void refuse_dimension(const std::string& text, const Written& written,
                                   const Unit& given, const Unit& expected,
                                   const std::string& where) {
    const Wanted want = wanted(expected);
    const std::string better = respelled(written.unit_text, expected);
    const std::string remedy =
        better.empty() ? "write it in " + (want.unit == "rad" ? "deg or rad" : want.unit)
                       : "did you mean " + example(written.number_text, better) + "?";
    refuse(where, fmt::format("{} [{}]", in_quotes(text), exponents(given)),
           fmt::format("must be {} [{}]", want.name, exponents(expected)), remedy);
}

// Angles have no dimension, but a turn is not a radian: see Unit in units.hpp.
void check_angle(const std::string& text, const Written& written, const Unit& given,
                 const Unit& expected, const std::string& where) {
    const bool wants_angle = !scaling::is_zero(expected.angle);
    const bool has_angle = !scaling::is_zero(given.angle);
    if (wants_angle && !has_angle && expected.dimension.dimensionless()) {
        refuse(where, in_quotes(text), "must be an angle with its unit",
               "write " + example(written.number_text, "deg"));
    }
    if (wants_angle && given.counts_cycles) {
        refuse(where, in_quotes(text), "must be a spin: Hz counts turns, not radians",
               fmt::format("write \"{} rpm\" or use rad/s", written.number * given.factor * 60.0));
    }
    if (!wants_angle && has_angle) {
        const Wanted want = wanted(expected);
        refuse(where, in_quotes(text),
               fmt::format("must be {}, and radians or turns are none", want.name),
               "write it in " + (want.unit == "1" ? "per cent or as a bare number" : want.unit));
    }
}

// number * factor, but by an exact power of ten where the factor is one: "1.2 um" is then 1.2e-6 as the compiler reads it,
// not its neighbour (1e-6 is no double).
double converted_number(double number, double factor) {
    const double exponent = std::round(std::log10(factor));
    const double power = std::pow(10.0, std::abs(exponent));
    const bool decimal =
        std::abs(exponent) <= 22.0 && std::abs(std::log10(factor) - exponent) < 1e-13;
    if (!decimal) return number * factor;
    return exponent < 0.0 ? number / power : number * power;
}

std::string suggested_unit(const Written& written, const UnitProblem& problem,
                           const Unit& expected) {
    std::vector<std::string> fitting;
    for (const std::string& unit : common_units()) {
        if (same_dimension(parse_normalised_unit(unit), expected)) fitting.push_back(unit);
    }
    // The whole unit may be misspelled ("Mpa"), or one symbol in it ("J/M^2"); a fitting unit is
    // the better guess.
    std::string near = nearest(written.unit_text, fitting);
    if (near.empty()) {
        const std::string symbol = nearest(problem.symbol, common_units());
        const std::size_t at =
            problem.symbol.empty() ? std::string::npos : written.unit_text.find(problem.symbol);
        if (!symbol.empty() && at != std::string::npos) {
            const std::string mended =
                std::string(written.unit_text).replace(at, problem.symbol.size(), symbol);
            if (readable_as(mended, expected)) near = mended;
        }
    }
    if (near.empty()) near = wanted(expected).unit;
    return "did you mean " + example(written.number_text, near) + "?";
}

double converted(const std::string& text, const Unit& expected, bool angle_matters,
                 const std::string& where) {
    const Written written = split(text, where);
    Unit given;
    try {
        if (!written.unit_text.empty()) given = parse_normalised_unit(written.unit_text);
    } catch (const UnitProblem& problem) {
        refuse(where, in_quotes(text),
               fmt::format("{} in place of {}", problem.what(), in_quotes(problem.symbol)),
               suggested_unit(written, problem, expected));
    }
    const bool bare = written.unit_text.empty();
    const bool pure = expected.dimension.dimensionless() && scaling::is_zero(expected.current);
    if (bare && !pure) refuse_bare(written.number, expected, where);
    if (!same_dimension(given, expected)) refuse_dimension(text, written, given, expected, where);
    if (angle_matters) check_angle(text, written, given, expected, where);
    return converted_number(written.number, given.factor);
}

}  // namespace

Unit parse_unit(const std::string& text, const std::string& where) {
    try {
        const std::string plain = normalise(text);
        return plain.empty() ? Unit{} : parse_normalised_unit(plain);
    } catch (const UnitProblem& problem) {
        refuse(where, in_quotes(text),
               fmt::format("{} in place of {}", problem.what(), in_quotes(problem.symbol)),
               suggestion(problem.symbol, common_units()));
    }
}

double to_si(const std::string& text, const scaling::Dimension& expected,
             const std::string& where) {
    Unit unit;
    unit.dimension = expected;
    return converted(text, unit, false, where);
}

double to_si(const std::string& text, const Unit& expected, const std::string& where) {
    return converted(text, expected, true, where);
}

void refuse_bare(double number, const Unit& expected, const std::string& where) {
    const Wanted want = wanted(expected);
    const std::string written = fmt::format("{}", number);
    refuse(where, written, fmt::format("must be {} with its unit", want.name),
           "write " + example(written, want.unit));
}

void refuse_bare(double number, const scaling::Dimension& expected, const std::string& where) {
    Unit unit;
    unit.dimension = expected;
    refuse_bare(number, unit, where);
}

std::string format_si(double value, const std::string& si_unit) {
    if (si_unit == "1" || si_unit.empty()) return fmt::format("{:.6g}", value);
    if (si_unit == "rad") return fmt::format("{:.6g} deg", value * 180.0 / std::numbers::pi);
    // The symbols that carry a prefix in daily use, at the front and in the first power.
    static constexpr std::array<std::string_view, 7> carriers{"m", "s", "N", "Pa", "J", "Hz", "C"};
    std::string unit = si_unit;
    double scaled = value;
    if (unit == "kg") {
        unit = "g";
        scaled *= 1e3;
    }
    const std::string_view first =
        std::string_view(unit).substr(0, unit.find_first_of("^/* 0123456789"));
    const bool whole =
        first.size() == unit.size() || unit[first.size()] == '/' || unit[first.size()] == '*';
    const bool carries = unit == "g" || (whole && std::find(carriers.begin(), carriers.end(),
                                                            first) != carriers.end());
    if (!carries || scaled == 0.0 || (std::abs(scaled) >= 0.1 && std::abs(scaled) < 1e3)) {
        return unit == "g" && std::abs(value) >= 0.1 ? fmt::format("{:.6g} kg", value)
                                                     : fmt::format("{:.6g} {}", scaled, unit);
    }
    static constexpr std::array<std::pair<double, const char*>, 9> steps{{{1e-15, "f"},
                                                                          {1e-12, "p"},
                                                                          {1e-9, "n"},
                                                                          {1e-6, "u"},
                                                                          {1e-3, "m"},
                                                                          {1.0, ""},
                                                                          {1e3, "k"},
                                                                          {1e6, "M"},
                                                                          {1e9, "G"}}};
    const auto* step = steps.begin();
    while (step + 1 != steps.end() && std::abs(scaled) >= (step + 1)->first * (1.0 - 1e-9)) ++step;
    return fmt::format("{:.6g} {}{}", scaled / step->first, step->second, unit);
}

}  // namespace cases
