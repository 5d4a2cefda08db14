// SPDX-License-Identifier: MIT
// Whether the data of a design fix a claimed order of the sizes of its effects.
#pragma once

#include "calibrate/effects.hpp"
#include "calibrate/identifiability.hpp"

#include <string>
#include <vector>

namespace calibrate {

struct Ranking {
    std::string claimed;  // "B > G > E"
    bool structural;      // each claimed effect is estimable
    double largest_t;     // |t| of any effect in any fit; 0 without degrees of freedom
    double t_needed;      // two-sided, 95 %
    std::vector<std::string>
        other;          // orders of fits with the same residuals, one per left-out term
    bool identifiable;  // structural, and every claimed effect differs from zero
    std::string why;    // one sentence
};

// `fits`: one of full rank, or one for each term that may be left out (effects.hpp). `claimed`:
// factors by letter, the largest effect first.
Ranking judged_ranking(const std::vector<std::string>& claimed,
                       const std::vector<NullVector>& null_vectors,
                       const std::vector<EffectFit>& fits);

// "B > E > F": the factors of a fit by |effect|, at most `count`.
std::string order_of(const EffectFit&, std::size_t count);

}  // namespace calibrate
