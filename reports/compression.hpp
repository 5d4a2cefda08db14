// SPDX-License-Identifier: MIT
// The compression study as a reader meets it: strength over grain size, each rule's curves, what the source states beside it.
#pragma once

#include "reports/json.hpp"
#include "reports/page.hpp"
#include "verify/compression_study.hpp"

#include <string>

namespace reports {

// yes: force as d^2 is equivalent at every h, the other rules differ at the largest, half of the speed changes nothing, and the
// bits are kept, all with the seeds for a claim. no: force as d^2 differs, another rule is equivalent, or the bits are not kept.
Verdict verdict_of(const verify::CompressionStudy&);

// "holds", "breaks" or "not decided".
const char* map_word(verify::Answer);

std::string text_of(const verify::CompressionStudy&);
Json to_json(const verify::CompressionStudy&);
Page page_of(const verify::CompressionStudy&, const Provenance&);

}  // namespace reports
