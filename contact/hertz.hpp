// SPDX-License-Identifier: MIT
// Hertz: normal force between two elastic spheres that do not adhere.
//   a = sqrt(R* d)            contact radius at the overlap d
//   F = 4/3 E* a d            F > 0 in compression; none without overlap
//   U = 8/15 E* a d^2         energy stored, dU/dd = F
// Hertz (1882), J. reine angew. Math. 92, 156; Johnson (1985), Contact Mechanics, section 4.2.
// Smooth, frictionless, a << R*. The root of the product R* d keeps the bits of a scaled contact.
#pragma once

#include "contact/concepts.hpp"
#include "scaling/quantities.hpp"

namespace contact {

struct Hertz {
    double e_star;  // Pa

    // Throws InvalidParameter unless > 0 and finite.
    static Hertz from(scaling::Pressure e_star);

    // m; Hertz has no length of its own, R* stands in and is not used.
    double length_scale(double r_star) const { return r_star; }

    NormalState at(double r_star, double /*length_scale*/, double overlap) const {
        const double d = overlap > 0.0 ? overlap : 0.0;
        const double a = std::sqrt(r_star * d);
        return {.force = 4.0 / 3.0 * e_star * a * d, .contact_radius = a};
    }

    double energy(double r_star, double /*length_scale*/, double overlap) const {  // J
        const double d = overlap > 0.0 ? overlap : 0.0;
        return 8.0 / 15.0 * e_star * std::sqrt(r_star * d) * d * d;
    }

    double pull_off_force(double /*r_star*/) const { return 0.0; }                             // N
    double tear_off_overlap(double /*r_star*/, double /*length_scale*/) const { return 0.0; }  // m
};

}  // namespace contact
