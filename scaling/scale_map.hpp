// SPDX-License-Identifier: MIT
// A scale map: by which factor every quantity changes when the grain grows by h, solved exactly
// from what is kept.
//
// Each factor is h^a (E'/E)^b with rational a and b; E'/E is a softening of the modulus, 1 unless
// stated. In logarithms a quantity of dimension rho^r L^l T^t has the factor r*rho + l*L + t*T, so
// that each kept quantity is one linear equation. An undistorted map has one ruler and one clock:
// length h and two more independent demands settle it, and then every dimensionless group is kept.
// A distorted map lets the surroundings have another ruler (apparatus_length) and another clock
// (time) than the grain (length, contact_time), as far as the demands need it and no further:
//   coarse graining   density, gravity, modulus, apparatus 1
//                     -> time 1, velocity 1, mass rate 1; contact time h, contact force h^2
// What even two rulers and two clocks cannot satisfy is imposed on that quantity alone.
// pi_groups.hpp says which groups break.
#pragma once

#include "scaling/quantity_table.hpp"
#include "scaling/schemes.hpp"

#include <map>
#include <string>
#include <vector>

namespace scaling {

// base^exponent; exact where base is a power of two and the result is one too.
double power_of(double base, const Rational& exponent);

// "1", "h", "h^-1/2", "h^2 (E'/E)^2/5"
std::string to_string(const Exponents&);

class ScaleMap {
  public:
    // h: model over original grain length, > 0. softening: E'/E, > 0, beside what the scheme does
    // to the modulus. Throws InvalidParameter where the demands contradict each other (naming the
    // fewest that do, and the way out) or leave a factor open (naming what is free and which
    // quantities would fix it).
    static ScaleMap solve(const Scheme& scheme, double h, double softening = 1.0);

    Exponents exponents(const std::string& quantity) const;
    Rational exponent(const std::string& quantity) const { return exponents(quantity).h; }
    double factor(const std::string& quantity) const { return value(exponents(quantity)); }
    double value(const Exponents&) const;  // h^a (E'/E)^b with this map's h and softening

    double h() const { return h_; }
    double softening() const { return softening_; }

    // Whether ruler, clock or a single quantity differs from what one similarity transformation
    // gives.
    bool distorted() const;
    // Demanded against the rest of the map; each stands for itself and no other factor follows it.
    const std::map<std::string, Exponents>& imposed() const { return imposed_; }
    bool apparatus_kept() const { return exponents("apparatus_length") == Exponents{}; }
    // Whether nothing demanded the strength of adhesion, so that an invariant must choose it
    // (adhesion.hpp).
    bool adhesion_is_open() const { return distorted() && !adhesion_demanded_; }

    // All factors are powers of two, so that a scaled run can have the same bits as the original
    // after rescaling.
    bool exact_in_binary() const;

    // This map with one factor replaced; surface_energy and work_of_adhesion go together (w = 2
    // gamma).
    ScaleMap with_imposed(const std::string& quantity, const Exponents&) const;

  private:
    struct Bases {
        Exponents grain_length, apparatus_length, density, time, contact_time;
    };
    ScaleMap(double h, double softening) : h_(h), softening_(softening) {}
    void settle(const Scheme& scheme);
    void impose(const std::string& quantity, const Exponents&);

    double h_, softening_;
    Bases bases_;
    std::map<std::string, Exponents> imposed_;
    bool adhesion_demanded_ = false;
};

}  // namespace scaling
