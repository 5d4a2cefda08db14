// SPDX-License-Identifier: MIT
// A dimension is three exact rational exponents, of mass, length and time. They are read off the
// Boost.Units type of a quantity by the compiler, so that no table of exponents is kept by hand and
// a type and its dimension cannot disagree.
#pragma once

#include <boost/rational.hpp>
#include <boost/units/dimensionless_type.hpp>
#include <boost/units/physical_dimensions/length.hpp>
#include <boost/units/physical_dimensions/mass.hpp>
#include <boost/units/physical_dimensions/time.hpp>
#include <boost/units/quantity.hpp>

#include <string>
#include <type_traits>

namespace scaling {

// Compare it with another Rational only: `r == 0` with a plain int recurses for ever in C++20 with
// Boost 1.74.
using Rational = boost::rational<int>;

std::string to_string(const Rational&);  // "2", "-1", "1/2"
bool is_zero(const Rational&);

// "2", "-1/2" -> Rational. Throws InvalidParameter naming `where` for anything else.
Rational rational_from(const std::string& text, const std::string& where);

struct Dimension {
    Rational mass{0}, length{0}, time{0};

    bool dimensionless() const { return is_zero(mass) && is_zero(length) && is_zero(time); }
    friend bool operator==(const Dimension& a, const Dimension& b) {
        return a.mass == b.mass && a.length == b.length && a.time == b.time;
    }
};

Dimension operator*(const Dimension&, const Dimension&);
Dimension operator/(const Dimension&, const Dimension&);
Dimension power(const Dimension&, const Rational& exponent);

std::string to_string(const Dimension&);               // "M L^-1 T^-2"; "1" without dimension
std::string in_density_length_time(const Dimension&);  // the same as "rho L^2 T^-2"

namespace detail {

// What one entry of a Boost.Units dimension list adds: tag = base dimension, N/D = its exponent.
template <class Tag>
void add_base(Dimension& sum, const Rational& exponent) {
    constexpr bool mass = std::is_same_v<Tag, boost::units::mass_base_dimension>;
    constexpr bool length = std::is_same_v<Tag, boost::units::length_base_dimension>;
    constexpr bool time = std::is_same_v<Tag, boost::units::time_base_dimension>;
    static_assert(mass || length || time, "only mass, length and time are base dimensions here");
    if constexpr (mass) sum.mass += exponent;
    if constexpr (length) sum.length += exponent;
    if constexpr (time) sum.time += exponent;
}

template <class List>
void add_dimensions(Dimension& sum) {
    if constexpr (!std::is_same_v<List, boost::units::dimensionless_type>) {
        using Entry = typename List::item;
        using Exponent = typename Entry::value_type;
        add_base<typename Entry::tag_type>(sum, Rational(static_cast<int>(Exponent::Numerator),
                                                         static_cast<int>(Exponent::Denominator)));
        add_dimensions<typename List::next>(sum);
    }
}

}  // namespace detail

// The dimension of a Boost.Units quantity type, e.g. dimension_of<Pressure>() = M L^-1 T^-2.
template <class Quantity>
Dimension dimension_of() {
    Dimension sum;
    detail::add_dimensions<typename Quantity::unit_type::dimension_type>(sum);
    return sum;
}

}  // namespace scaling
