// SPDX-License-Identifier: MIT
// Capillary bridge: the pull of a small liquid bridge of constant volume between two spheres.
//   F_c = 4 pi gamma R* cos(theta)                    closed: while the solids are in contact
//   F(h) = F_c (1 - h/sqrt(h^2 + A)),  A = V/(pi R*)  across a gap h > 0
//   h_r = (1 + theta/2) V^(1/3)                       it ruptures there
//   W(h) = F_c (h - sqrt(h^2 + A) + sqrt(A))          work against it from touch to h, dW/dh = F
// gamma surface tension, V volume of one bridge, theta contact angle, R* = R at a wall. F pulls:
// it is > 0 here, and counts as a negative normal force.
// The bridge forms when the solids touch and is gone after rupture, so that the work of stretching
// it to h_r is lost: heat. Quasi-static, no viscous force; small bridges, V << R*^3; gravity and
// what two bridges at one grain take from each other are left out.
// Force: Rabinovich, Esayanur & Moudgil (2005), Langmuir 21, 10992, without the term of the wetted
// circle; R* by Derjaguin. Rupture: Lian, Thornton & Adams (1993), J. Colloid Interface Sci. 161,
// 138. W: integrated by hand.
#pragma once

#include "scaling/quantities.hpp"

#include <cmath>
#include <numbers>

namespace contact {

struct CapillaryBridge {
    double pull_per_radius = 0.0;  // N/m, 4 pi gamma cos(theta); 0: no liquid
    double volume = 0.0;           // m^3
    double rupture_gap = 0.0;      // m

    // Throws InvalidParameter unless surface tension and volume are > 0 and finite and the angle,
    // in rad, is >= 0 and below pi/2, beyond which liquid does not pull.
    static CapillaryBridge from(scaling::EnergyPerArea surface_tension, scaling::Volume volume,
                                double contact_angle);

    bool acts() const { return pull_per_radius > 0.0; }
    double closed(double r_star) const { return pull_per_radius * r_star; }  // N

    double across(double r_star, double gap) const {  // N; gap >= 0
        if (!(gap < rupture_gap)) return 0.0;
        return closed(r_star) * (1.0 - gap / std::sqrt(gap * gap + area(r_star)));
    }
    double work(double r_star, double gap) const {  // J; 0 <= gap <= rupture_gap
        const double root = std::sqrt(area(r_star));
        return closed(r_star) * gap * (1.0 - gap / (std::sqrt(gap * gap + area(r_star)) + root));
    }

  private:
    double area(double r_star) const { return volume / (std::numbers::pi * r_star); }  // m^2
};

}  // namespace contact
