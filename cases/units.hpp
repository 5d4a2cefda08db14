// SPDX-License-Identifier: MIT
// Numbers with a unit, as people write them ("0.19 J/m^2", "1.2 µm", "2050 kg m⁻³"), to SI and
// back. Grammar: docs/case.md. Symbols, prefixes and sizes of units are those of udunits2, products
// and (rational) powers are ours. Every function throws scaling::InvalidInput. Safe to call from
// several threads.
#pragma once

#include "scaling/dimension.hpp"
#include "scaling/quantities.hpp"

#include <string>

namespace cases {

// A unit taken apart. SI value = written number * factor. Angles are dimensionless, but remembered:
// "rpm" and "Hz" are both 1/s and yet differ by 2 pi, so a value that must be a spin is refused in
// Hz, and a frequency in rpm.
struct Unit {
    double factor = 1.0;
    scaling::Dimension dimension{};  // mass, length, time
    scaling::Rational current{0};    // exponent of the ampere: charges only
    scaling::Rational angle{0};      // exponent of the radian
    bool counts_cycles = false;      // Hz
    std::string text;                // as written
};

// `where` is the place in the input that a message names.
Unit parse_unit(const std::string& text, const std::string& where);

// "1.2 um" -> 1.2e-6. The number must carry a unit of this dimension, unless that is 1: then it may
// stand bare.
double to_si(const std::string& text, const scaling::Dimension& expected, const std::string& where);
double to_si(const std::string& text, const Unit& expected, const std::string& where);

template <class Q>
Q quantity(const std::string& text, const std::string& where) {
    return Q::from_value(to_si(text, scaling::dimension_of<Q>(), where));
}

// A bare number where a unit belongs: the message suggests what to write.
[[noreturn]] void refuse_bare(double number, const Unit& expected, const std::string& where);
[[noreturn]] void refuse_bare(double number, const scaling::Dimension& expected,
                              const std::string& where);

// The way back, for people: format_si(1.2e-6, "m") is "1.2 um", format_si(0.19, "J/m^2") is "0.19
// J/m^2", of "rad" the degrees. Six digits at most; a prefix below 0.1 and from 1000 on, where the
// first symbol can carry one.
std::string format_si(double value, const std::string& si_unit);

}  // namespace cases
