// SPDX-License-Identifier: MIT
// Closed forms of the JKR contact that judge a scaled grain before anything is simulated (the law
// itself: contact/jkr.hpp).
//   F(a)     = 4 E* a^3 / (3 R*) - sqrt(8 pi w E* a^3)      > 0 in compression
//   delta(a) = a^2 / R* - sqrt(2 pi w a / E*)               > 0 for overlap
// a contact radius, w work of adhesion (2 gamma for like solids). Johnson, Kendall & Roberts
// (1971), Proc. R. Soc. Lond. A 324, 301, doi:10.1098/rspa.1971.0141. All five follow from these
// two lines; w = 0 gives Hertz.
#pragma once

#include "scaling/quantities.hpp"

namespace scaling {

struct JkrPair {
    EnergyPerArea work_of_adhesion;  // >= 0
    Pressure e_star;                 // > 0
    Length r_star;                   // > 0

    Force pull_off_force() const;  // 3/2 pi w R*: the deepest tension, whatever E*

    // Where F = 0: a0^3 = 9 pi w R*^2 / (2 E*).
    Length zero_load_contact_radius() const;

    // Overlap under a load >= 0: a^3 = 3 R*/(4 E*) (P + 3 pi w R* + sqrt(6 pi w R* P + (3 pi w
    // R*)^2)), then delta(a).
    Length overlap_under(Force load) const;

    // Gap > 0 at which a contact pulled by displacement tears: d(delta)/da = 0 at 3/4 (pi^2 w^2 R*
    // / E*^2)^(1/3).
    Length tear_off_gap() const;

    // Work of pulling from delta = 0 to the tear-off, > 0: (2 pi)^(5/3) (3/10 + 2^(-8/3)/5) (w^5
    // R*^4 / E*^2)^(1/3).
    Energy separation_work() const;

    // Slowest approach that still separates again, were this work the only loss: sqrt(2 W / m*).
    Velocity sticking_speed(Mass m_star) const;
};

// Deepest overlap of an elastic impact without adhesion, Hertz: (15 m* v^2 / (16 E*
// sqrt(R*)))^(2/5).
Length hertz_impact_overlap(Mass m_star, Velocity approach, Pressure e_star, Length r_star);

}  // namespace scaling
