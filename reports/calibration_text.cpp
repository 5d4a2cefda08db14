// SPDX-License-Identifier: MIT
#include "reports/calibration.hpp"
#include "reports/numbers.hpp"
#include "reports/text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace reports {

using namespace calibrate;

Verdict verdict_of(const Replayed& r) {
    const std::size_t compared = r.replay.digits.size();
    const std::string numbers =
        r.replay.mismatches == 0
            ? fmt::format("all {} printed numbers come out again", compared)
            : fmt::format("{} of {} printed numbers come out again",
                          compared - static_cast<std::size_t>(r.replay.mismatches), compared);
    const Ranking& ranking = r.audit.ranking;
    return {r.holds() ? Answer::yes : Answer::no,
            ranking.identifiable ? "The ranking is borne out by the runs"
                                 : "The ranking does not follow from the runs",
            fmt::format("{}; {}: {}.", numbers, ranking.claimed, ranking.why)};
}

std::string text_of(const Replayed& r) {
    const Verdict verdict = verdict_of(r);
    std::string text = fmt::format("{}\n{}\n", verdict.headline, wrapped(verdict.why, 100, 0));
    for (const Recomputed& d : r.replay.digits)
        if (!d.agrees)
            text += wrapped(fmt::format("  differs  {}, {}: printed {}, recomputed {}", d.table,
                                        d.what, d.printed.text, number(d.value)),
                            100, 11) +
                    "\n";
    std::string topic;
    for (const Observation& o : r.observations) {
        if (o.topic != topic) text += fmt::format("\n{}\n", topic = o.topic);
        const std::string unit = o.unit == "1" ? "" : " " + o.unit;
        const std::string value = std::isfinite(o.value) ? " = " + number(o.value) + unit : "";
        text += wrapped(fmt::format("  {:<8} {}{}: {}", scaling::to_string(o.judgement), o.name,
                                    value, tidy(o.text)),
                        100, 11) +
                "\n";
    }
    return text;
}

}  // namespace reports
