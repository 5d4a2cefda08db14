// SPDX-License-Identifier: MIT
// A diagnosis for people: the answer, the page's limits, plain text for a terminal.
#pragma once

#include "diagnose/verdict.hpp"
#include "reports/verdict.hpp"

#include <string>
#include <vector>

namespace reports {

// yes: consistent; no: explained or unexplained; cannot tell: ambiguous or undecided.
Answer answer_of(diagnose::Answer);

// The answer with what is named, and the summary as one paragraph.
Verdict verdict_of(const diagnose::Verdict&);

// What a diagnosis cannot show, whatever it says.
std::vector<std::string> limits_of(const diagnose::Verdict&);

// For a terminal: verdict, where, hypotheses, parameters, errors before and after, what would change
// it, the next recording, warnings.
std::string text_of(const diagnose::Verdict&);

// "air drag and tilt"; "nothing left out" of an empty list, "something that is not in the catalogue"
// of {"unknown"}.
std::string effects_in_words(const std::vector<std::string>&);

// "drop-1, z: recorded lies above simulated by 31 mm (rms) for speed from 2.1 m/s to 4.8 m/s"
std::string located_in_words(const diagnose::Located&);

// "1 mm to 3 mm": the 90 % interval.
std::string interval_in_words(const diagnose::Estimate&);

std::string chance_in_words(double p_value);  // "0.03", "less than 0.001", "not known"

}  // namespace reports
