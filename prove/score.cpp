// SPDX-License-Identifier: MIT
#include "prove/score.hpp"

#include "prove/score_parts.hpp"

#include <algorithm>
#include <cmath>

namespace prove {
namespace {

constexpr double z95 = 1.959963984540054;

using score_parts::Judged;
using score_parts::share;
using score_parts::Tally;
using score_parts::tally;

bool one_concealed(const Judged& j) {
    return j.key->kind == Kind::single || j.key->kind == Kind::look_alike;
}
bool far(const Judged& j) { return one_concealed(j) && j.key->separation.d >= 5.0; }
bool middling(const Judged& j) {
    return one_concealed(j) && j.key->separation.d >= 3.0 && j.key->separation.d < 5.0;
}
bool near(const Judged& j) {
    return one_concealed(j) && j.key->separation.d < 3.0 && j.key->lambda >= 25.0;
}
bool is_null(const Judged& j) { return j.key->kind == Kind::null; }
bool alarm(const Judged& j) { return j.verdict != nullptr && j.verdict->alarm(); }

void nulls(const std::vector<Judged>& all, std::vector<Line>& lines) {
    lines.push_back(
        share("false alarm on nulls at nominal 5 %", "3-8 %",
              tally(all, is_null, [](const Judged& j) { return j.verdict == nullptr || alarm(j); }),
              0.03, 0.08));
    for (const char* kind : {"white", "heavy", "correlated", "mis_set"})
        lines.push_back(
            share("  of these", kind,
                  tally(
                      all, [&](const Judged& j) { return is_null(j) && j.key->subkind == kind; },
                      [](const Judged& j) { return j.verdict == nullptr || alarm(j); }),
                  0.0, 1.0));
    lines.push_back(
        share("a name given on a null", "<= 1 %",
              tally(all, is_null,
                    [](const Judged& j) { return j.verdict == nullptr || !j.named.empty(); }),
              0.0, 0.01));
}

void power(const std::vector<Judged>& all, std::vector<Line>& lines, double low, double high,
           const char* figure, const char* bar) {
    double oracle = 0.0;
    Tally t;
    for (const Judged& j : all) {
        if (!one_concealed(j) && j.key->kind != Kind::pair) continue;
        if (j.key->lambda < low || j.key->lambda >= high) continue;
        ++t.count;
        t.hits += alarm(j) ? 1 : 0;
        oracle += j.key->oracle_power;
    }
    Line line{figure, bar};
    line.count = t.count;
    if (t.count > 0) {
        const Wilson w = wilson(t.hits, t.count);
        const double mean = oracle / t.count;
        line.value = t.hits / oracle;
        line.bounds = Wilson{w.low / mean, w.high / mean};
        if (bar[0] != '\0') line.met = line.value >= 0.9;
    }
    lines.push_back(line);
}

void names(const std::vector<Judged>& all, bool went_on, std::vector<Line>& lines) {
    const auto right = [](const Judged& j) { return j.right(); };
    const auto wrong = [](const Judged& j) { return j.wrong(); };
    lines.push_back(share("right name where D >= 5", ">= 95 %", tally(all, far, right), 0.95, 1.0));
    lines.push_back(score_parts::macro_recall(all));
    lines.push_back(score_parts::least_recall(all));
    lines.push_back(score_parts::worst_pair(all));
    lines.push_back(share("right name, D 3-5", ">= 75 %", tally(all, middling, right), 0.75, 1.0));
    lines.push_back(share("wrong name, D 3-5", "<= 5 %", tally(all, middling, wrong), 0.0, 0.05));
    lines.push_back(share(
        "ambiguous with the truth in it, D < 3", ">= 90 %",
        tally(all, near, [](const Judged& j) { return j.ambiguous_with_truth(); }), 0.9, 1.0));
    lines.push_back(share("wrong name, D < 3", "<= 5 %", tally(all, near, wrong), 0.0, 0.05));
    lines.push_back(share("right after the recording it asked for, D < 3", ">= 90 %",
                          tally(
                              all,
                              [went_on](const Judged& j) {
                                  return went_on && near(j) && j.verdict != nullptr &&
                                         j.verdict->verdict == "ambiguous";
                              },
                              [](const Judged& j) { return j.right_after(); }),
                          0.9, 1.0));
    lines.push_back(share("too weak to see (lambda < 25, D < 3): no wrong name", "",
                          tally(
                              all,
                              [](const Judged& j) {
                                  return one_concealed(j) && j.key->separation.d < 3.0 &&
                                         j.key->lambda < 25.0;
                              },
                              [](const Judged& j) { return j.verdict != nullptr && !j.wrong(); }),
                          0.0, 1.0));
}

void others(const std::vector<Judged>& all, std::vector<Line>& lines) {
    const auto outside = [](const Judged& j) {
        return j.key->kind == Kind::outside && j.key->lambda >= 25.0 &&
               j.key->pair_separation >= 5.0;
    };
    lines.push_back(share("outside the catalogue: unknown", ">= 85 %",
                          tally(all, outside,
                                [](const Judged& j) {
                                    return j.verdict != nullptr &&
                                           j.verdict->verdict == "unexplained" && j.named.empty();
                                }),
                          0.85, 1.0));
    lines.push_back(share("outside the catalogue: wrong name", "<= 5 %",
                          tally(all, outside, [](const Judged& j) { return j.wrong(); }), 0.0,
                          0.05));
    const auto pair = [](const Judged& j) {
        return j.key->kind == Kind::pair && j.key->lambda_given_other.size() == 2 &&
               std::min(j.key->lambda_given_other[0], j.key->lambda_given_other[1]) >= 25.0;
    };
    const auto both = [](const Judged& j) { return j.right(); };
    lines.push_back(share("two effects: both named", ">= 75 %", tally(all, pair, both), 0.75, 1.0));
    lines.push_back(share(
        "  of these, no other two within D = 5", "",
        tally(
            all, [&](const Judged& j) { return pair(j) && j.key->pair_separation >= 5.0; }, both),
        0.0, 1.0));
    lines.push_back(share(
        "  of these, cancelling in the headline", "",
        tally(
            all, [&](const Judged& j) { return pair(j) && j.key->subkind == "cancelling"; }, both),
        0.0, 1.0));
    lines.push_back(
        share("two effects: one right, none wrong", "",
              tally(all, pair, [](const Judged& j) { return !j.named.empty() && !j.wrong(); }), 0.0,
              1.0));
    const auto numerical = [](const Judged& j) { return j.key->kind == Kind::numerical; };
    lines.push_back(share("numerical artefact named", "", tally(all, numerical, both), 0.0, 1.0));
}

void against_baselines(const Keys& keys, const Judgements& judged, ScoreTable& table) {
    const int own = table.wrong_names;
    for (const auto& [name, verdicts] : judged.baselines) {
        const int theirs = wrong_names(keys, verdicts);
        const Calibration c = calibration(keys, verdicts);
        Line line{"wrong names against " + name, name == "bic" ? "<= half" : ""};
        line.count = static_cast<int>(keys.size());
        line.value = theirs > 0 ? static_cast<double>(own) / theirs : 0.0;
        line.note = std::to_string(own) + " against " + std::to_string(theirs);
        if (name == "bic") line.met = 2 * own <= theirs;
        table.lines.push_back(line);
        Line brier{"Brier score against " + name, name == "bic" ? "<= half" : ""};
        brier.count = line.count;
        brier.value = c.brier > 0.0 ? table.calibration.brier / c.brier : 0.0;
        if (name == "bic") brier.met = brier.value <= 0.5;
        table.lines.push_back(brier);
        Tally t;
        for (const Judged& j : score_parts::judged(keys, verdicts))
            if (far(j)) ++t.count, t.hits += j.right() ? 1 : 0;
        Line right = share("  right name where D >= 5, by this", "", t, 0.0, 1.0);
        right.bar = name;
        table.lines.push_back(right);
    }
}

}  // namespace

Wilson wilson(int hits, int count) {
    if (count <= 0) return {0.0, 1.0};
    const double n = count, p = hits / n, z2 = z95 * z95;
    const double centre = (p + z2 / (2.0 * n)) / (1.0 + z2 / n);
    const double half = z95 / (1.0 + z2 / n) * std::sqrt(p * (1.0 - p) / n + z2 / (4.0 * n * n));
    return {std::max(0.0, centre - half), std::min(1.0, centre + half)};
}

int wrong_names(const Keys& keys, const Verdicts& verdicts) {
    int wrong = 0;
    for (const Judged& j : score_parts::judged(keys, verdicts))
        wrong += j.verdict != nullptr && j.wrong() ? 1 : 0;
    return wrong;
}

ScoreTable score(const Keys& keys, const Judgements& judgements) {
    const std::vector<Judged> all = score_parts::judged(keys, judgements.first, &judgements.after);
    ScoreTable table;
    table.cases = static_cast<int>(keys.size());
    for (const Judged& j : all) table.missing += j.verdict == nullptr ? 1 : 0;
    table.wrong_names = wrong_names(keys, judgements.first);
    nulls(all, table.lines);
    power(all, table.lines, 25.0, 1e300, "power over the oracle's, lambda >= 25", ">= 0.9");
    power(all, table.lines, 10.0, 25.0, "power over the oracle's, lambda 10 to 25", "");
    names(all, !judgements.after.empty(), table.lines);
    others(all, table.lines);
    score_parts::places(all, table.lines);
    score_parts::parameters(all, table.lines);
    table.lines.push_back(share("held-out RMS within 1.15 of the oracle's, named cases", ">= 85 %",
                                tally(
                                    all,
                                    [](const Judged& j) {
                                        return j.verdict != nullptr && j.right() &&
                                               j.key->kind != Kind::numerical &&
                                               j.key->kind != Kind::null;
                                    },
                                    [](const Judged& j) {
                                        return j.verdict->held_out_extended &&
                                               *j.verdict->held_out_extended <=
                                                   1.15 * j.key->oracle_held_out;
                                    }),
                                0.85, 1.0));
    table.calibration = calibration(keys, judgements.first);
    Line ece{"expected calibration error over hypotheses", "<= 0.05"};
    ece.count = static_cast<int>(judgements.first.size());
    ece.value = table.calibration.expected_error;
    if (ece.count > 0) ece.met = ece.value <= 0.05;
    table.lines.push_back(ece);
    against_baselines(keys, judgements, table);
    score_parts::stability(keys, judgements, table.lines);
    table.confusion = score_parts::confusion(all);
    return table;
}

}  // namespace prove
