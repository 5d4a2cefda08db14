// SPDX-License-Identifier: MIT
#pragma once

#include "diagnose/verdict.hpp"
#include "reports/json.hpp"

namespace reports {

// The format `similitude-verdict/1` of docs/diagnose.md, keys in its order. Values are SI but where a
// text carries its own unit; probabilities have six decimals, and those of the hypotheses sum to 1
// as printed. What is not finite is null and has its reason under "reasons" of the same object.
Json to_json(const diagnose::Verdict&, const Provenance&);

}  // namespace reports
