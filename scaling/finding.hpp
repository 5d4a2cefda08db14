// SPDX-License-Identifier: MIT
// Physics out of its range is a result, not an error: a Finding stands beside the number it is
// about.
#pragma once

#include <string>

namespace scaling {

enum class Judgement { fine, caution, unusable };

struct Finding {
    std::string name;     // snake_case, stable: "zero_load_contact_radius_over_radius"
    double value;         // dimensionless
    std::string rule;     // "< 0.1"
    Judgement judgement;  // what the value means for the user
    std::string text;     // one sentence: what it means and what to do instead
};

const char* to_string(Judgement);  // "fine", "caution", "unusable"

}  // namespace scaling
