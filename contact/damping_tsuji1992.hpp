// SPDX-License-Identifier: MIT
// Tsuji's dashpots: the damping that gives a Hertzian impact one restitution e at every speed.
//   c = factor sqrt(S m*),   factor = 2 sqrt(5/6) beta,   beta = -ln e/sqrt(ln^2 e + pi^2)
//   normal S_n = 2 E* a,   tangential S_t = 8 G* a
// S is the stiffness of the contact at its true radius a, so that under adhesion the dashpot stays
// finite at and below zero overlap; e is then met only well above the sticking speed. For Hertz it
// is exact where the contact ends at zero overlap (tension in the last moments let through).
// Tsuji, Tanaka & Ishida (1992), Powder Technol. 71, 239 (form of c); Antypov & Elliott (2011),
// EPL 94, 50004 (factor in closed form).
#pragma once

#include <cmath>

namespace contact {

struct DampingTsuji1992 {
    double factor;  // 1

    // Throws InvalidParameter unless 0 <= restitution <= 1.
    static DampingTsuji1992 from(double restitution);

    // kg/s. The root of a m* is written so that a compiler takes it once for both.
    double normal(double e_star, double contact_radius, double m_star) const {
        return factor * std::sqrt(2.0 * e_star) * std::sqrt(contact_radius * m_star);
    }
    double tangential(double g_star, double contact_radius, double m_star) const {
        return factor * std::sqrt(8.0 * g_star) * std::sqrt(contact_radius * m_star);
    }
};

}  // namespace contact
