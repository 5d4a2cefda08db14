// SPDX-License-Identifier: MIT
#pragma once

#include "reports/runs.hpp"
#include "verify/compression_study.hpp"

namespace reports {

// Unconfined strength over h, one line per adhesive rule through its means, a mark per sample.
Figure strength_figure(const verify::CompressionStudy&);

// Stress over strain of a rule: mean over seeds at each strain as a line, lowest to highest as a band, one of each per h.
Figure confined_figure(const verify::RuleResult&);
Figure crushed_figure(const verify::RuleResult&);

}  // namespace reports
