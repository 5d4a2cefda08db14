// SPDX-License-Identifier: MIT
// Advice as a reader meets it: which grain, why, what is lost, what it costs, and what would catch the loss.
#pragma once

#include "reports/json.hpp"
#include "reports/page.hpp"
#include "verify/advice.hpp"
#include "verify/comparison.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace reports {

struct Advice {
    std::string title, source;  // the case's
    std::string map;            // file and extent
    double budget, tolerance;   // s for one heap; deg
    verify::PowderGroups powder;
    std::vector<verify::AdvisedGrain> considered;  // coarsest first
    std::optional<std::size_t> chosen{};
    // What would catch the loss: heaps of a finer grain beside those of the chosen one.
    double finer_h = 0.0, finer_seconds = 0.0, spread = 0.0;  // 1; s a heap; deg, from seed to seed
    std::size_t seeds = 0;                                    // a side
    std::vector<std::string> notes{};                         // what was changed beside the grain
    std::optional<verify::Comparison> check{};                // where it was made
    std::string next{};                                       // commands that make it
};

// yes: a grain, all of it inside the map; outside validity: a grain, some of it beyond the map; no: no grain that can be afforded keeps
// the angle; cannot tell: a grain, but the map leaves open whether the angle stays. A check decides that, and a difference is a no.
Verdict verdict_of(const Advice&);
std::string text_of(const Advice&);
Json to_json(const Advice&, const Provenance&);
Page page_of(const Advice&, const Provenance&);

}  // namespace reports
