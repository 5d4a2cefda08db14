// SPDX-License-Identifier: MIT
#include "scaling/dimension.hpp"

#include "scaling/errors.hpp"

#include <charconv>

namespace scaling {

namespace {

void append(std::string& text, const char* symbol, const Rational& exponent) {
    if (is_zero(exponent)) return;
    if (!text.empty()) text += ' ';
    text += symbol;
    if (exponent != Rational(1)) text += '^' + to_string(exponent);
}

// The whole of `text` as an int; false if anything else stands there.
bool read_int(const std::string& text, int& value) {
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, value);
    return result.ec == std::errc{} && result.ptr == end;
}

}  // namespace

std::string to_string(const Rational& r) {
    std::string text = std::to_string(r.numerator());
    if (r.denominator() != 1) text += '/' + std::to_string(r.denominator());
    return text;
}

bool is_zero(const Rational& r) { return r.numerator() == 0; }

Rational rational_from(const std::string& text, const std::string& where) {
    const auto slash = text.find('/');
    int numerator = 0, denominator = 1;
    const bool read = read_int(text.substr(0, slash), numerator) &&
                      (slash == std::string::npos || read_int(text.substr(slash + 1), denominator));
    if (!read || denominator <= 0) {
        throw InvalidParameter(mistake(where, '"' + text + '"',
                                       "must be a whole number or a fraction",
                                       "for example 2, -1 or 1/2"));
    }
    return {numerator, denominator};
}

Dimension operator*(const Dimension& a, const Dimension& b) {
    return {a.mass + b.mass, a.length + b.length, a.time + b.time};
}

Dimension operator/(const Dimension& a, const Dimension& b) {
    return {a.mass - b.mass, a.length - b.length, a.time - b.time};
}

Dimension power(const Dimension& a, const Rational& exponent) {
    return {a.mass * exponent, a.length * exponent, a.time * exponent};
}

std::string to_string(const Dimension& d) {
    std::string text;
    append(text, "M", d.mass);
    append(text, "L", d.length);
    append(text, "T", d.time);
    return text.empty() ? "1" : text;
}

std::string in_density_length_time(const Dimension& d) {
    std::string text;
    append(text, "rho", d.mass);
    append(text, "L", d.length + Rational(3) * d.mass);
    append(text, "T", d.time);
    return text.empty() ? "1" : text;
}

}  // namespace scaling
