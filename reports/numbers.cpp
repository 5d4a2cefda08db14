// SPDX-License-Identifier: MIT
#include "reports/numbers.hpp"

#include "cases/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string_view>
#include <utility>

namespace reports {

namespace {

bool digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }
bool word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// "1.2e+06" -> "1.2e6"
std::string short_exponent(std::string text) {
    const std::size_t e = text.find('e');
    if (e == std::string::npos) return text;
    const int exponent = std::atoi(text.c_str() + e + 1);
    return fmt::format("{}e{}", text.substr(0, e), exponent);
}

double four_digits(double value) {
    return std::strtod(fmt::format("{:.4g}", value).c_str(), nullptr);
}

// End of a signed whole number or fraction that starts at `at`: "2", "-1/2", "2/5".
std::size_t end_of_exponent(const std::string& text, std::size_t at) {
    std::size_t end = at;
    if (end < text.size() && (text[end] == '-' || text[end] == '+')) ++end;
    const std::size_t digits = end;
    while (end < text.size() && digit(text[end])) ++end;
    if (end == digits) return at;
    if (end + 1 < text.size() && text[end] == '/' && digit(text[end + 1])) {
        ++end;
        while (end < text.size() && digit(text[end])) ++end;
    }
    return end;
}

// The exponent behind a '^' at `at`, without its brackets; moves `at` behind it, or returns "".
std::string raised(const std::string& text, std::size_t& at) {
    const bool bracket = at + 1 < text.size() && text[at + 1] == '(';
    const std::size_t from = at + (bracket ? 2 : 1);
    const std::size_t end = end_of_exponent(text, from);
    if (end == from || (bracket && (end >= text.size() || text[end] != ')'))) return "";
    at = bracket ? end + 1 : end;
    return text.substr(from, end - from);
}

// Whether an 'e' at `at` separates mantissa and exponent of a number.
bool exponent_mark(const std::string& text, std::size_t at) {
    if (text[at] != 'e' || at == 0 || !digit(text[at - 1])) return false;
    const std::size_t end = end_of_exponent(text, at + 1);
    return end != at + 1 && (end == text.size() || !word(text[end]));
}

// Whether the 'u' at `at` is the prefix micro behind a number: "1.2 um".
bool micro(const std::string& text, std::size_t at) {
    if (text[at] != 'u' || at < 2 || text[at - 1] != ' ' || !digit(text[at - 2])) return false;
    constexpr std::string_view bases = "msNJgCP";
    return at + 1 < text.size() && bases.find(text[at + 1]) != std::string_view::npos;
}

// Two characters that stand for one sign: how many, and which; nullptr for none.
std::pair<std::size_t, const char*> relation(const std::string& text, std::size_t at) {
    static constexpr std::array<std::pair<std::string_view, const char*>, 3> signs{
        {{">=", "\u2265"}, {"<=", "\u2264"}, {"+-", "\u00b1"}}};
    for (const auto& [written, sign] : signs)
        if (text.compare(at, written.size(), written) == 0) return {written.size(), sign};
    return {0, nullptr};
}

// A Greek letter spelled out as a word of its own: how many characters, and the letter; nullptr for
// none.
std::pair<std::size_t, const char*> greek(const std::string& text, std::size_t at) {
    static constexpr std::array<std::pair<std::string_view, const char*>, 8> letters{
        {{"rho", "\u03c1"},
         {"sigma", "\u03c3"},
         {"pi", "\u03c0"},
         {"eta", "\u03b7"},
         {"gamma", "\u03b3"},
         {"beta", "\u03b2"},
         {"delta", "\u03b4"},
         {"nu", "\u03bd"}}};
    if (at > 0 && word(text[at - 1])) return {0, nullptr};
    for (const auto& [name, letter] : letters) {
        const std::size_t end = at + name.size();
        const bool ends =
            end >= text.size() || std::isalnum(static_cast<unsigned char>(text[end])) == 0;
        if (text.compare(at, name.size(), name) == 0 && ends) return {name.size(), letter};
    }
    return {0, nullptr};
}

// What stands below the line behind a one-letter symbol that ends before `at`: "po" of F_po; "" for
// none.
std::string lowered(const std::string& text, std::size_t at, bool symbol) {
    if (!symbol || at >= text.size() || text[at] != '_') return "";
    std::size_t end = at + 1;
    while (end < text.size() && word(text[end])) ++end;
    return text.substr(at + 1, end - at - 1);
}

const char* entity(char c) {
    switch (c) {
        case '&':
            return "&amp;";
        case '<':
            return "&lt;";
        case '>':
            return "&gt;";
        case '"':
            return "&quot;";
        default:
            return nullptr;
    }
}

}  // namespace

std::string number(double value) {
    if (!std::isfinite(value)) return "none";
    const double rounded = four_digits(value);
    if (std::abs(rounded) >= 1e4 && std::abs(rounded) < 1e5) return fmt::format("{:.0f}", rounded);
    return short_exponent(fmt::format("{:.4g}", value));
}

std::string quantity(double value, const std::string& si_unit) {
    if (!std::isfinite(value)) return "none";
    static constexpr std::array<std::pair<double, const char*>, 4> long_times{
        {{2.0 * 365.25 * 86400.0, "years"},
         {2.0 * 86400.0, "d"},
         {2.0 * 3600.0, "h"},
         {120.0, "min"}}};
    if (si_unit == "s") {
        for (const auto& [from, unit] : long_times) {
            const double one = unit == std::string_view("min") ? 60.0 : from / 2.0;
            if (value >= from)
                return number(std::strtod(fmt::format("{:.3g}", value / one).c_str(), nullptr)) +
                       " " + unit;
        }
    }
    // Takes no prefix, and has an e in it that is no exponent.
    if (si_unit == "deg") return number(value) + " deg";
    if (si_unit == "rad") return number(value * 180.0 / std::numbers::pi) + " deg";
    return short_exponent(cases::format_si(four_digits(value), si_unit));
}

std::string degrees(double radians) {
    return fmt::format("{:.1f}", radians * 180.0 / std::numbers::pi);
}

std::string count(double value) {
    if (!(std::abs(value) >= 1000.0) || std::abs(value) >= 1e6) return number(value);
    const long long whole = std::llround(value);
    return fmt::format("{} {:03}", whole / 1000, std::llabs(whole % 1000));
}

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (const char* named = entity(c))
            out += named;
        else
            out += c;
    }
    return out;
}

std::string words(const std::string& name) {
    static constexpr std::array<std::pair<std::string_view, const char*>, 11> people{
        {{"youngs", "Young's"},
         {"poisson", "Poisson"},
         {"rayleigh", "Rayleigh"},
         {"hamaker", "Hamaker"},
         {"bond", "Bond"},
         {"tabor", "Tabor"},
         {"froude", "Froude"},
         {"cauchy", "Cauchy"},
         {"reynolds", "Reynolds"},
         {"stokes", "Stokes"},
         {"galilei", "Galilei"}}};
    std::string out;
    for (std::size_t at = 0; at < name.size();) {
        const std::size_t end = std::min(name.find_first_of("_ ", at), name.size());
        const std::string_view one = std::string_view(name).substr(at, end - at);
        const auto* person = std::find_if(people.begin(), people.end(),
                                          [&](const auto& p) { return p.first == one; });
        out += person != people.end() ? std::string_view(person->second) : one;
        if (end < name.size()) out += ' ';
        at = end + 1;
    }
    return out;
}

std::string with_micro(const std::string& text) {
    std::string out;
    for (std::size_t at = 0; at < text.size(); ++at) {
        if (micro(text, at))
            out += "\u00b5";
        else
            out += text[at];
    }
    return out;
}

std::string typeset(const std::string& text) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        if (text[at] == '^') {
            if (const std::string exponent = raised(text, at); !exponent.empty()) {
                out += "<sup>" + exponent + "</sup>";
                continue;
            }
        }
        if (exponent_mark(text, at)) {
            const bool one =
                text[at - 1] == '1' && (at == 1 || (!word(text[at - 2]) && text[at - 2] != '.'));
            if (one) out.pop_back();  // 1e5 is 10^5
            out += fmt::format("{}10<sup>{}</sup>", one ? "" : "\u00d7",
                               std::atoi(text.c_str() + at + 1));
            at = end_of_exponent(text, at + 1);
            continue;
        }
        if (const auto [written, sign] = relation(text, at); sign != nullptr) {
            out += sign;
            at += written;
            continue;
        }
        const auto [spelled, letter] = greek(text, at);
        const bool symbol =
            letter != nullptr || (std::isalpha(static_cast<unsigned char>(text[at])) != 0 &&
                                  (at == 0 || !word(text[at - 1])));
        if (letter != nullptr)
            out += letter;
        else
            out += micro(text, at) ? "\u00b5" : escaped(text.substr(at, 1));
        at += letter != nullptr ? spelled : 1;
        if (const std::string below = lowered(text, at, symbol); !below.empty()) {
            out += "<sub>" + below + "</sub>";
            at += below.size() + 1;
        }
    }
    return out;
}

std::string tidy(const std::string& text) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        if (!exponent_mark(text, at)) {
            out += text[at++];
            continue;
        }
        out += fmt::format("e{}", std::atoi(text.c_str() + at + 1));
        at = end_of_exponent(text, at + 1);
    }
    return out;
}

}  // namespace reports
