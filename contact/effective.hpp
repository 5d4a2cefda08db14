// SPDX-License-Identifier: MIT
// The effective constants of a pair: what two bodies of unlike stuff and size amount to in contact.
//   1/E* = (1 - nu_i^2)/E_i + (1 - nu_j^2)/E_j                                  normal response
//   1/G* = 2 (2 - nu_i)(1 + nu_i)/E_i + 2 (2 - nu_j)(1 + nu_j)/E_j              tangential response
//   1/R* = 1/R_i + 1/R_j,   1/m* = 1/m_i + 1/m_j
// A wall is a partner of infinite radius and mass with its own E and nu: the same formulas hold,
// and R* = R, m* = m to the last bit. Johnson (1985), Contact Mechanics, chapters 4 and 7.
#pragma once

#include "scaling/quantities.hpp"

#include <limits>

namespace contact {

struct Material {
    scaling::Pressure youngs_modulus;
    double poisson_ratio;
    scaling::Density density;
};

inline constexpr double wall_radius = std::numeric_limits<double>::infinity();  // m
inline constexpr double wall_mass = std::numeric_limits<double>::infinity();    // kg

// Both throw InvalidParameter unless E > 0 and finite, -1 < nu <= 1/2 in both materials; the
// density takes no part.
scaling::Pressure e_star(const Material& i, const Material& j);
scaling::Pressure g_star(const Material& i, const Material& j);

// Mass of a solid sphere. Throws InvalidParameter unless density and radius are > 0 and finite.
scaling::Mass sphere_mass(const Material&, scaling::Length radius);

// a b/(a + b) for a, b > 0, of which one may be infinite. Symmetric in a and b, and exactly the
// finite one at a wall, because the smaller is divided by 1 + smaller/larger.
inline double reduced(double a, double b) {
    const double smaller = a < b ? a : b;
    const double larger = a < b ? b : a;
    return smaller / (1.0 + smaller / larger);
}

inline double r_star(double r_i, double r_j) { return reduced(r_i, r_j); }  // m
inline double m_star(double m_i, double m_j) { return reduced(m_i, m_j); }  // kg

}  // namespace contact
