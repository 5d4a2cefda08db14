// SPDX-License-Identifier: MIT
// JKR: normal force between two adhering elastic spheres, as it is.
//   F = 4 E* a^3/(3 R*) - sqrt(8 pi w E* a^3)      F > 0 in compression
//   d = a^2/R* - sqrt(2 pi w a/E*)                 d > 0 for overlap
// a contact radius, w work of adhesion (NOT surface energy: w = 2 gamma for like solids).
// With L^3 = pi w R*^2/(2 E*), s = sqrt(a/L) and D = d R*/L^2 every contact is one curve:
//   D = s^4 - 2 s
//   F = (2/3) pi w R* s^3 (s^3 - 3)
//   U = (pi w L^2/2) (8/15 s^10 - 8/3 s^7 + 2 s^4 + 12/5 2^(1/3)),   dU/dd = F, U(d = 0) = 0
// s^3 = 3: no force. 2: touch, 8/9 of the pull-off force pulls. 3/2: deepest tension, the pull-off
// force 3/2 pi w R*. 1/2: fold of the curve, 5/9 of it; there is no contact beyond.
// A contact is born at d = 0 and lives until the fold: that hysteresis costs
// 7.0922 (w^5 R*^4/E*^2)^(1/3) of work.
// Johnson, Kendall & Roberts (1971), Proc. R. Soc. Lond. A 324, 301, doi:10.1098/rspa.1971.0141;
// the curve in s and its energy are derived from their two equations (docs/laws/jkr.md).
// Quasi-static, no viscous term; meant for a Tabor number above 5.
#pragma once

#include "contact/concepts.hpp"
#include "contact/scale_free.hpp"
#include "scaling/quantities.hpp"

#include <numbers>

namespace contact {

// Where a stretched contact ends: at the fold of d(a), as a grain under its own inertia does, or
// already at the gap of the deepest tension, as under a dead load (and in LAMMPS), which keeps only
// about half of the work.
enum class TearOff { fold, max_tension };

struct Jkr {
    double e_star;  // Pa
    double w;       // J/m^2, work of adhesion
    TearOff tear_off = TearOff::fold;

    // Throws InvalidParameter unless both are > 0 and finite.
    static Jkr from(scaling::Pressure e_star, scaling::EnergyPerArea work_of_adhesion,
                    TearOff tear_off = TearOff::fold);

    double length_scale(double r_star) const {  // L, m
        return cube_root(0.5 * std::numbers::pi * w * r_star * r_star / e_star);
    }

    // Below the tear-off overlap: as at the fold.
    NormalState at(double r_star, double length_scale, double overlap) const {
        const double s = root(overlap * (r_star / (length_scale * length_scale)));
        const double s3 = s * s * s;
        return {.force = 2.0 / 3.0 * std::numbers::pi * w * r_star * s3 * (s3 - 3.0),
                .contact_radius = length_scale * s * s};
    }

    double energy(double r_star, double length_scale, double overlap) const {  // J
        const double area = length_scale * length_scale;
        const double s = root(overlap * r_star / area);
        const double s3 = s * s * s;
        const double u = s * s3 * (s3 * (8.0 / 15.0 * s3 - 8.0 / 3.0) + 2.0);
        return 0.5 * std::numbers::pi * w * area * (u + 2.4 * root_of_two);
    }

    double pull_off_force(double r_star) const { return 1.5 * std::numbers::pi * w * r_star; }  // N

    double tear_off_overlap(double r_star, double length_scale) const {  // m
        const double d = tear_off == TearOff::fold ? fold_d : max_tension_d;
        return d * length_scale * length_scale / r_star;
    }

  private:
    static constexpr double root_of_two = 1.2599210498948731648;    // 2^(1/3)
    static constexpr double fold_s = 1.0 / root_of_two;             // dD/ds = 4 s^3 - 2 = 0
    static constexpr double fold_d = -1.5 * fold_s;                 // s (s^3 - 2) there
    static constexpr double max_tension_s = 1.1447142425533318678;  // 1.5^(1/3)
    static constexpr double max_tension_d = -0.5 * max_tension_s;   // s (s^3 - 2) there

    // The stable root s >= fold_s of s^4 - 2 s = D. With s = fold_s + y and q = D - fold_d it is
    // y^2 (y^2 + 4 fold_s y + 6 fold_s^2) = q: no double root is left at the fold, and no branch.
    // The unknown is t = y/sqrt(q), so that nothing divides by zero there. The start has the right
    // limit at the fold and, to leading order, far from it; between them it is too large by at most
    // 0.5 %. Halley's step makes that 1e-7, Newton's round-off, both from above.
    static double root(double d) {
        const double q = d > fold_d ? d - fold_d : 0.0;
        const double r = std::sqrt(q);
        const double start = 1.0 / (std::sqrt(start_a + r) + start_c);
        const double y = r * start;
        const double value = start * start * (y * (y + 4.0 * fold_s) + 6.0 * fold_s * fold_s) - 1.0;
        const double slope = start * (y * (4.0 * y + 12.0 * fold_s) + 12.0 * fold_s * fold_s);
        const double bend = y * (12.0 * y + 24.0 * fold_s) + 12.0 * fold_s * fold_s;
        const double t = start - 2.0 * value * slope / (2.0 * slope * slope - value * bend);
        const double z = r * t;
        const double rest = t * t * (z * (z + 4.0 * fold_s) + 6.0 * fold_s * fold_s) - 1.0;
        const double steep = t * (z * (4.0 * z + 12.0 * fold_s) + 12.0 * fold_s * fold_s);
        return fold_s + r * (t - rest / steep);
    }
    // sqrt(start_a) + start_c = sqrt(6) fold_s; start_c is chosen so that the start is never too small.
    static constexpr double start_c = 0.75;
    static constexpr double start_a = 1.4260173137190577;  // (sqrt(6) fold_s - 3/4)^2
};

}  // namespace contact
