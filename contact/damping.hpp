// SPDX-License-Identifier: MIT
// The dashpots of a contact: Tsuji's, viscoelastic ones, or both side by side.
//   c_n = factor sqrt(2 E* a m*) + eta a m*
// One struct and not a choice of types: each type would double the number of loops that the core is
// compiled to. What is not wanted is zero and adds nothing, to the last bit.
#pragma once

#include "contact/damping_tsuji1992.hpp"
#include "contact/damping_viscoelastic.hpp"

namespace contact {

struct Damping {
    DampingTsuji1992 tsuji{0.0};
    DampingViscoelastic viscoelastic{0.0, 0.0};

    Damping() = default;
    Damping(DampingTsuji1992 law) : tsuji(law) {}
    Damping(DampingViscoelastic law) : viscoelastic(law) {}

    double normal(double e_star, double contact_radius, double m_star) const {  // kg/s
        const double other = viscoelastic.normal(contact_radius, m_star);
        return tsuji.normal(e_star, contact_radius, m_star) + other;
    }
};

}  // namespace contact
