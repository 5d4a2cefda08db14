// SPDX-License-Identifier: MIT
// One self-contained HTML page: opens from an e-mail, prints, needs neither script nor network.
// Verdict first; a section whose part is empty is left out.
#pragma once

#include "cases/case.hpp"
#include "diagnose/verdict.hpp"
#include "reports/checks.hpp"
#include "reports/provenance.hpp"
#include "reports/runs.hpp"
#include "reports/verdict.hpp"
#include "scaling/scale_study.hpp"

#include <optional>
#include <string>
#include <vector>

namespace reports {

struct Page {
    std::string title{}, source{};  // the case's
    Verdict verdict{};
    std::optional<scaling::ScaleStudy> study{};
    std::optional<scaling::ScaleStudy>
        beside{};  // the same case under another scheme: its factors and groups are shown along
    std::optional<Verification>
        verification{};  // its comparisons become sections, after those of `runs`
    std::vector<RunSection> runs{};
    std::string runs_heading{};  // empty: by what is in the page
    std::optional<diagnose::Verdict> diagnosis{};
    std::string checks_heading = "Exact answers";
    std::vector<std::string> limits{};  // what the result does not show, a sentence each
    Provenance provenance{};
    std::string data{};  // JSON of the same result, embedded as it is; may be empty
};

std::string html(const Page&);

// The page of one answer, its limits included. Of runs: the verdict is the first one's; cannot tell without any.
Page page_of(const cases::Case&, const scaling::ScaleStudy&, const Provenance&);
Page page_of(const cases::Case&, const std::vector<RunSection>&, const Provenance&);
Page page_of(const cases::Case&, const diagnose::Verdict&, const Provenance&);

// What a scale study by itself cannot show.
std::vector<std::string> limits_of(const scaling::ScaleStudy&);

// What small heaps on one machine cannot show.
std::vector<std::string> limits_of(const Verification&);

}  // namespace reports
