// SPDX-License-Identifier: MIT
#include "prove/score_parts.hpp"

#include <algorithm>

namespace prove {
namespace {

using score_parts::Judged;
using score_parts::share;
using score_parts::Tally;
using score_parts::tally;

// Where the likelihood ratio of the truth against the nearest wrong effect names the truth in 95 draws of 100: Phi(D/2) = 0.95.
constexpr double oracle_can_tell = 3.29;

bool is_null(const Judged& j) { return j.key->kind == Kind::null; }
bool tellable(const Judged& j) { return !is_null(j) && j.key->separation.d >= oracle_can_tell; }
bool beyond_telling(const Judged& j) { return !is_null(j) && !tellable(j); }
bool right(const Judged& j) { return j.right(); }
bool wrong(const Judged& j) { return j.wrong(); }
bool named(const Judged& j) { return j.verdict == nullptr || !j.named.empty(); }

Line nulls_named(const std::vector<Judged>& all) {
    const Tally t = tally(all, is_null, named);
    Line line = share("a name given on a null", "<= 1 of 40", t, 0.0, 1.0);
    if (t.count > 0) line.met = 40 * t.hits <= std::max(40, t.count);
    return line;
}

}  // namespace

ScoreTable heap_score(const Keys& keys, const Verdicts& verdicts) {
    const std::vector<Judged> all = score_parts::judged(keys, verdicts);
    ScoreTable table;
    table.cases = static_cast<int>(keys.size());
    for (const Judged& j : all) table.missing += j.verdict == nullptr ? 1 : 0;
    table.wrong_names = wrong_names(keys, verdicts);
    std::vector<Line>& lines = table.lines;
    lines.push_back(nulls_named(all));
    lines.push_back(
        share("a mismatch called on a null", "",
              tally(all, is_null,
                    [](const Judged& j) { return j.verdict == nullptr || j.verdict->alarm(); }),
              0.0, 1.0));
    lines.push_back(share("right name where the oracle can tell", ">= 85 %",
                          tally(all, tellable, right), 0.85, 1.0));
    for (const char* effect : {"adhesion", "rolling_resistance", "polydispersity", "tilt",
                               "measurement_offset", "measurement_scale"})
        lines.push_back(share(
            "  of these", effect,
            tally(
                all, [&](const Judged& j) { return tellable(j) && j.truth.front() == effect; },
                right),
            0.0, 1.0));
    lines.push_back(
        share("wrong name where the oracle can tell", "", tally(all, tellable, wrong), 0.0, 1.0));
    lines.push_back(
        share("wrong name where it cannot", "", tally(all, beyond_telling, wrong), 0.0, 1.0));
    lines.push_back(
        share("cancelling: right name, or ambiguous with the truth in it", ">= 90 %",
              tally(
                  all, [](const Judged& j) { return j.key->subkind == "cancelling"; },
                  [](const Judged& j) { return j.right() || j.ambiguous_with_truth(); }),
              0.9, 1.0));
    constexpr double allowed = 1.3;  // times the noise floor
    lines.push_back(
        share("held-out error within 1.3 of the noise floor, named cases", ">= 80 %",
              tally(
                  all, [](const Judged& j) { return j.verdict != nullptr && !j.named.empty(); },
                  [](const Judged& j) {
                      return j.verdict->held_out_extended &&
                             *j.verdict->held_out_extended <= allowed * j.key->noise_floor;
                  }),
              0.8, 1.0));
    table.calibration = calibration(keys, verdicts);
    table.confusion = score_parts::confusion(all);
    return table;
}

}  // namespace prove
