// SPDX-License-Identifier: MIT
// What is asked of heaps while a case with piles is judged: more of them where hypotheses end, fresh ones to confirm a name; and
// what is said where only angles were recorded.
#pragma once

#include "diagnose/judge.hpp"
#include "diagnose/piles.hpp"

namespace diagnose {

// Two rounds: the user's model and every single effect are fitted by the emulator, and heaps poured where the likeliest of them end.
void ask_where_it_matters(const Piles&, const cases::Case&, const Settings&);

struct Confirmed {
    bool foreseen =
        true;  // fresh heaps of the found model and of the runner-up are what the emulator said
    bool recorded = true;  // the recordings are of the kind of the found model's
};
// Fresh heaps of the found model and of the runner-up, in every apparatus, with what the instrument adds by their fits; a warning
// tells how they compare. Where the runner-up's are as near to the recordings, the verdict becomes ambiguous.
Confirmed confirm_by_fresh_heaps(Judge&, const Candidate& found);

// More heaps where the found model and the runner-up end.
void learn_about(const Judge&, const Candidate& found);

// Where the found model's fresh heaps are to the end not like the recordings nothing is named.
void withdraw_names(Verdict&);

// Every recording to be fitted is a pile's angle.
bool only_angles(const cases::Case&);
Verdict undecided_by_angles(const cases::Case&, const Settings&);

}  // namespace diagnose
