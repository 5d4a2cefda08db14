// SPDX-License-Identifier: MIT
// A replayed and audited calibration as a reader meets it.
#pragma once

#include "calibrate/observations.hpp"
#include "reports/json.hpp"
#include "reports/page.hpp"

#include <string>
#include <vector>

namespace reports {

// no: a printed number does not come out again, or the ranking concluded cannot be.
Verdict verdict_of(const calibrate::Replayed&);

// replay: every printed number with what was computed, the mismatches again; level means, ascent,
// analysis of variance, line. audit: rank, null vectors, aliases, fits, what failed runs imply,
// ranking, findings.
Json to_json(const calibrate::Replayed&);

std::string text_of(const calibrate::Replayed&);

// Numbers, effects, failed runs, refinement, findings by topic; every number last.
std::vector<RunSection> calibration_sections(const calibrate::Replayed&);

Page page_of(const calibrate::Replayed&, const Provenance&);

}  // namespace reports
