// SPDX-License-Identifier: MIT
// Head-on impact of two spheres as an ordinary differential equation, integrated by GSL (Prince-Dormand 8, relative error
// 1e-12) with its end located. The force laws are written here anew: nothing is shared with what is tested.
//   m* d'' = -F(d) - c(d) d',   d overlap, d(0) = 0, d'(0) = impact speed
//   c = 2 sqrt(5/6) beta sqrt(2 E* a m*),   beta = -ln e/sqrt(ln^2 e + pi^2)          (Tsuji et al. 1992; Antypov & Elliott 2011)
//   Hertz: F = 4/3 E* sqrt(R*) d^(3/2), a = sqrt(R* d); ends at d = 0
//   JKR:   F = 4 E* a^3/(3 R*) - sqrt(8 pi w E* a^3), d = a^2/R* - sqrt(2 pi w a/E*)       (Johnson, Kendall & Roberts 1971)
//          ends at the fold of d(a)
#pragma once

namespace verify {

struct TwoSpheres {
    double e_star;            // Pa
    double r_star;            // m
    double m_star;            // kg
    double work_of_adhesion;  // J/m^2; 0: Hertz
    double restitution;       // 1, > 0; sets the dashpot
};

struct Impact {
    double rebound_speed;    // m/s, > 0 apart; 0 where they stick
    double duration;         // s, from touch to end
    double largest_overlap;  // m
};
// Throws std::runtime_error if GSL fails.
Impact integrate_impact(const TwoSpheres&, double impact_speed);

// Work to part two adhering spheres from touch to the fold, J: -integral of F dd, by quadrature over a.
double sticking_work(const TwoSpheres&);

// The gap at the fold of d(a), m, > 0: dd/da = 0 at a^3 = pi w R*^2/(8 E*), where d = -3 a^2/R*.
double tear_off_gap(const TwoSpheres&);

}  // namespace verify
