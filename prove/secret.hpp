// SPDX-License-Identifier: MIT
// An effect that acts and is not in the user's model, and how its strength is set: by bisection, until the discrepancy that
// remains after a refit has the size that was asked for.
#pragma once

#include "prove/figures.hpp"
#include "prove/skeleton.hpp"
#include "prove/terms.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace prove {

// Strength 0 < s <= 1 to the world; the other parameters of the effect have been drawn.
struct Dial {
    Term term;
    std::function<void(World&, double s)> turn;
    double least = 0.003;  // below it the effect is too weak to be one
};

// Nothing where the effect cannot act in this skeleton. `term` comes from terms(); ranges of channels from the base's truth.
std::optional<Dial> dial_for(const Term&, const Skeleton&, Dice&);
std::optional<Dial> outside_dial(Outside, const Skeleton&, Dice&);
std::vector<Outside> outside_kinds(Rig);

// Turns until IDR is within 10 % of the target; where the strongest is too weak, or the weakest too strong, the noise of all
// experiments is scaled by at most 3.5. Nothing where that does not reach. Returns the strength.
std::optional<double> solve_strength(Skeleton&, const Dial&, double target);

}  // namespace prove
