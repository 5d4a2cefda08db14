// SPDX-License-Identifier: MIT
// What is asked of heaps while a case with piles is judged: more of them where hypotheses end, fresh ones to confirm a name; and
// what is said where only angles were recorded.
#pragma once

#include "diagnose/judge.hpp"
#include "diagnose/piles.hpp"

namespace diagnose {

// Two rounds: the user's model and every single effect are fitted by the emulator, and heaps poured where the likeliest of them end.
void ask_where_it_matters(const Piles&, const cases::Case&, const Settings&);

// Fresh heaps of the found model and of the runner-up beside the recordings of the first pile; a warning tells how they compare.
// Where the runner-up's are as near, the verdict becomes ambiguous. False where either are not what the emulator said, or where
// the recording is none of those of a named model.
bool confirm_by_fresh_heaps(Judge&, const Candidate& found);

// More heaps where the found model and the runner-up end.
void learn_about(const Judge&, const Candidate& found);

// Where fresh heaps contradict to the end nothing is named.
void withdraw_names(Verdict&);

// Every recording to be fitted is a pile's angle.
bool only_angles(const cases::Case&);
Verdict undecided_by_angles(const cases::Case&, const Settings&);

}  // namespace diagnose
