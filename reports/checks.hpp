// SPDX-License-Identifier: MIT
// Verification as a reader meets it: exact answers, the same bits, heaps against each other.
#pragma once

#include "reports/json.hpp"
#include "reports/runs.hpp"
#include "reports/verdict.hpp"
#include "verify/check.hpp"
#include "verify/similarity.hpp"
#include "verify/sleep_study.hpp"

#include <optional>
#include <string>
#include <vector>

namespace reports {

struct Verification {
    std::vector<verify::Check> checks;
    std::optional<verify::SimilarityResult>
        similarity;                             // its first comparison is the one that is judged
    std::optional<verify::SleepStudy> sleep{};  // instead of it
};

// no: a check fails, bits differ, a control made wrong on purpose passes, or the first comparison
// is different. cannot tell: nothing fails, but that comparison has the seeds for a claim and is
// not decided. With fewer seeds nothing is claimed of it, and nothing is held against it.
Verdict verdict_of(const Verification&);

RunSection comparison_section(const verify::Comparison&);

// Those of the verification, the one that is judged first.
std::vector<const verify::Comparison*> comparisons_of(const Verification&);

// What sleep saved, in a sentence.
std::string saved_text(const verify::SleepStudy&);

// Engine and contact rules of the heaps: "LAMMPS 29 Sep 2021 - Update 2, 2 ranks; contact rules that LAMMPS has".
std::string heaps_by(const verify::SimilarityResult&);

// One row per pair: scheme, h, grains, hash of either side, same or not. The first row is the
// heading; empty without pairs.
TextTable bits_table(const Verification&);

// "2e-6 of it" where relative, "1 ms" where absolute, "none" for zero.
std::string tolerance_text(const verify::Check&);

// checks: every one with expected, got, unit, tolerance, relative, reason, source, passed, the bits
// pairs among them; comparisons: sides with every sample, quantities with intervals; findings; heaps_by; sleep: what it saved.
Json to_json(const Verification&);
Json to_json(const verify::Comparison&);

std::string text_of(const Verification&);

}  // namespace reports
