// SPDX-License-Identifier: MIT
// How numbers look in everything that a person reads; nothing else in reports/ chooses digits.
#pragma once

#include "scaling/dimension.hpp"
#include "scaling/scale_map.hpp"

#include <string>

namespace reports {

// Four significant digits: "14.14", "0.005", "1.25e8"; "not a number" never: a value that is not
// finite reads "none".
std::string number(double value);

// Four significant digits with a prefix: "1.2 um", "85.71 MPa", "2.5 h". Seconds from two minutes
// on become min, h, d, years.
std::string quantity(double value, const std::string& si_unit);

std::string degrees(
    double radians);  // "35.7", without a unit: no estimator is good for more than a tenth

// A count for people: "1 500", "2.4e9".
std::string count(double value);

// Text as HTML: &, <, > and " escaped, a^2 and a^(1/2) raised, 1.2e-6 as 1.2 x 10 raised to -6, um
// as the micro sign, >=, <= and +- as one sign each, Greek letters as such, F_po with what follows
// below the line.
std::string typeset(const std::string& text);

// The same text with exponents in their shortest form, 1e+05 as 1e5.
std::string tidy(const std::string& text);

std::string words(
    const std::string& name);  // snake_case as words, people with a capital: "Young's modulus"

std::string with_micro(
    const std::string& text);  // "1.2 um" with the micro sign, nothing else changed

std::string escaped(const std::string& text);  // for XML text and attributes, nothing else changed

}  // namespace reports
