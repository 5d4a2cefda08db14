// SPDX-License-Identifier: MIT
// The normal force N that sliding and rolling friction multiply. Codes differ:
//   elastic_plus_two_pull_off   max(0, F_e + 2 F_po)         LAMMPS (jkr, dmt), Lethe
//   total_plus_two_pull_off     max(0, F_e + F_d + 2 F_po)   LIGGGHTS, MercuryDPM at F_po = 0
//   repulsive_part              max(0, F_rep)                EDEM (JKR)
//   elastic                     max(0, F_e)                  no friction from adhesion
// At F_e = F_d = 0 these are 2, 2, 4 and 0 times F_po.
// F_e elastic and F_d damping force along n, > 0 in compression; F_po pull-off force; F_rep the
// repulsive part of F_e. Solving JKR for it gives F_rep = F_e + 2 F_po + 2 sqrt(F_po (F_e + F_po));
// where the tangential force has peeled the contact the root is gone, and F_e + 2 F_po is left:
// Thornton & Yin (1991), Powder Technol. 65, 153.
#pragma once

namespace contact {

enum class FrictionCap {
    elastic_plus_two_pull_off,
    total_plus_two_pull_off,
    repulsive_part,
    elastic
};

// The part of an elastic force that repels: Hertz' pressure over the true contact radius, 4 E*
// a^3/(3 R*). For Hertz it is the whole force. N, from Pa, m, m.
inline double repulsive_force(double e_star, double r_star, double contact_radius) {
    return 4.0 / 3.0 * e_star / r_star * (contact_radius * contact_radius * contact_radius);
}

// N, >= 0, from forces in N with the signs above.
inline double cap_force(FrictionCap cap, double elastic, double damping, double pull_off,
                        double repulsive) {
    const double pull_offs = cap == FrictionCap::elastic ? 0.0 : 2.0;
    const double held = elastic + pull_offs * pull_off;
    const double damped = cap == FrictionCap::total_plus_two_pull_off ? 1.0 : 0.0;
    const double peeled = cap == FrictionCap::repulsive_part ? 1.0 : 0.0;
    const double chosen = (1.0 - peeled) * (held + damped * damping) + peeled * repulsive;
    return chosen > 0.0 ? chosen : 0.0;
}

}  // namespace contact
