// SPDX-License-Identifier: MIT
#include "reports/verdict.hpp"

#include "reports/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace reports {

namespace {

using scaling::GroupChange;
using scaling::ScaleStudy;

// How many groups break, and the one that changes most.
std::string broken_sentence(const ScaleStudy& study) {
    std::size_t broken = 0;
    const GroupChange* worst = nullptr;
    const auto size = [](const GroupChange& g) { return std::max(g.ratio, 1.0 / g.ratio); };
    for (const GroupChange& g : study.groups) {
        if (g.kept) continue;
        ++broken;
        if (worst == nullptr || size(g) > size(*worst)) worst = &g;
    }
    if (worst == nullptr) return "";
    return fmt::format(
        "{} of {} dimensionless groups change, {} the most: it is {} times what it was", broken,
        study.groups.size(), words(worst->group.name), number(worst->ratio));
}

std::string usability_sentence(const scaling::AdhesionPrediction& adhesion) {
    const auto last =
        std::find_if(adhesion.findings.begin(), adhesion.findings.end(),
                     [](const scaling::Finding& f) { return f.name == "physically_usable"; });
    return last == adhesion.findings.end() ? "see the adhesion's findings" : last->text;
}

}  // namespace

const char* to_string(Answer answer) {
    switch (answer) {
        case Answer::yes:
            return "yes";
        case Answer::no:
            return "no";
        case Answer::cannot_tell:
            return "cannot tell";
        case Answer::outside_validity:
            return "outside validity";
    }
    return "";
}

Verdict verdict_of(const ScaleStudy& study) {
    const std::string scaling =
        fmt::format("h = {}, scheme {}", number(study.h), study.scheme.name);
    if (study.adhesion && !study.adhesion->physically_usable)
        return {Answer::outside_validity, "The scaled grain is no usable grain (" + scaling + ")",
                usability_sentence(*study.adhesion)};
    const std::string broken = broken_sentence(study);
    if (!broken.empty()) return {Answer::no, "Not similar: groups break (" + scaling + ")", broken};
    return {Answer::yes, "Similar (" + scaling + ")",
            fmt::format("all {} dimensionless groups of this case are kept{}", study.groups.size(),
                        study.exact_in_binary ? ", and all factors are powers of two" : "")};
}

}  // namespace reports
