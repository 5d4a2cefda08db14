// SPDX-License-Identifier: MIT
// Ageing: the work of adhesion of a contact grows with the logarithm of its age.
//   w(t) = w (1 + c log10(1 + t/t0))
// t age, since the solids touched; c growth per decade; t0 the age from which on decades count.
// Beads that rest in moist air hold a slope that grows with the logarithm of the time of rest:
// bridges condense between asperities by activation, wider gaps later. Bocquet, Charlaix, Ciliberto
// & Crassous (1998), Nature 396, 735; Restagno, Gayvallet, Bocquet & Charlaix
// (1999), arXiv:cond-mat/9908142. They have ln(t) above a first time; the 1 makes t = 0 finite.
#pragma once

#include "contact/jkr.hpp"

#include <cmath>

namespace contact {

struct Ageing {
    double rate = 0.0;   // c, 1; 0: none
    double onset = 1.0;  // t0, s

    // Throws InvalidParameter unless rate >= 0 and onset > 0, both finite.
    static Ageing from(double rate, scaling::Time onset);

    bool acts() const { return rate > 0.0; }
    double growth(double age) const {
        return 1.0 + rate * std::log10(1.0 + age / onset);
    }  // w(t)/w

    // The normal law of a contact of that age, s; what does not adhere does not age.
    Jkr aged(Jkr law, double age) const {
        law.w *= growth(age);
        return law;
    }
    template <class Law>
    Law aged(const Law& law, double /*age*/) const {
        return law;
    }
};

}  // namespace contact
