// SPDX-License-Identifier: MIT
// The answer in a few words and the one sentence why, which stands first in every report.
#pragma once

#include "scaling/scale_study.hpp"

#include <string>

namespace reports {

enum class Answer { yes, no, cannot_tell, outside_validity };

const char* to_string(Answer);  // "yes", "no", "cannot tell", "outside validity"

struct Verdict {
    Answer answer;
    std::string headline;  // no full stop
    std::string why;       // one sentence
};

// yes: every group is kept; no: groups break; outside validity: the predicted adhesion makes no
// usable grain.
Verdict verdict_of(const scaling::ScaleStudy&);

}  // namespace reports
