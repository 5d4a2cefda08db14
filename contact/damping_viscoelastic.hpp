// SPDX-License-Identifier: MIT
// Viscoelastic dashpots: the damping that LAMMPS allows under adhesion.
//   normal c_n = eta a m*,   tangential c_t = ratio c_n
// a contact radius, m* reduced mass. There is no restitution behind it, and eta is no material
// constant: it carries 1/(m s), so that a grain scaled by L and T needs eta/(L T).
// LAMMPS manual, pair_style granular, damping viscoelastic; there after Brilliantov, Spahn, Hertzsch
// & Poschel (1996), Phys. Rev. E 53, 5382, whose dashpot grows with a too but knows no mass.
#pragma once

#include "scaling/quantities.hpp"

namespace contact {

struct DampingViscoelastic {
    using Eta = scaling::units::quantity<
        scaling::units::divide_typeof_helper<scaling::si::wavenumber, scaling::si::time>::type>;

    double eta;               // 1/(m s)
    double tangential_ratio;  // 1; x_gammat in LAMMPS

    // Throws InvalidParameter unless both are >= 0 and finite.
    static DampingViscoelastic from(Eta eta, double tangential_ratio);

    double normal(double contact_radius, double m_star) const {  // kg/s, from m and kg
        return eta * contact_radius * m_star;
    }
    double tangential(double contact_radius, double m_star) const {
        return tangential_ratio * normal(contact_radius, m_star);
    }
};

}  // namespace contact
