// SPDX-License-Identifier: MIT
// Blind cases as a page: the bars, what was named for what, how far probabilities can be believed.
#pragma once

#include "prove/score.hpp"
#include "reports/page.hpp"

#include <string>
#include <vector>

namespace reports {

// `cost`: one line on the time that verdicts took. `limits`: what these cases do not show.
Page page_of(const prove::ScoreTable&, const std::string& cost, std::vector<std::string> limits,
             const Provenance&);

}  // namespace reports
