// SPDX-License-Identifier: MIT
#include "prove/score.hpp"
#include "prove/score_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace prove {
namespace {

constexpr int bins = 10;

// p(h) against whether h is what acts, over the hypotheses that a verdict lists; what it does not list has probability 0.
struct Counter {
    double probability[bins] = {}, frequency[bins] = {};
    int count[bins] = {};
    void add(double p, bool true_one) {
        const int k = std::clamp(static_cast<int>(p * bins), 0, bins - 1);
        probability[k] += p;
        frequency[k] += true_one ? 1.0 : 0.0;
        ++count[k];
    }
    double error() const {
        double sum = 0.0;
        int n = 0;
        for (int k = 0; k < bins; ++k)
            sum += std::abs(probability[k] - frequency[k]), n += count[k];
        return n > 0 ? sum / n : 0.0;
    }
};

std::string matrix(const Confusion& confusion) {
    std::string out;
    for (const auto& [truth, answers] : confusion) {
        int total = 0;
        for (const auto& [answer, n] : answers) total += n;
        std::vector<std::pair<int, std::string>> order;
        for (const auto& [answer, n] : answers) order.emplace_back(-n, answer);
        std::sort(order.begin(), order.end());
        out += fmt::format("  {:<28} {:>4}  ", truth, total);
        for (const auto& [n, answer] : order) out += fmt::format(" {} {}", answer, -n);
        out += "\n";
    }
    return out;
}

}  // namespace

Calibration calibration(const Keys& keys, const Verdicts& verdicts) {
    Counter all, top;
    double brier = 0.0;
    int n = 0;
    for (const auto& j : score_parts::judged(keys, verdicts)) {
        ++n;
        if (j.verdict == nullptr || j.verdict->hypotheses.empty()) {
            brier += 1.0;
            continue;
        }
        bool listed = false;
        const Hypothesis* best = nullptr;
        for (const Hypothesis& h : j.verdict->hypotheses) {
            const bool acts = h.effects == j.truth;
            listed = listed || acts;
            // Thousands of pairs at nothing would hide every error.
            if (h.probability >= 0.01 || acts) all.add(h.probability, acts);
            brier += (h.probability - (acts ? 1.0 : 0.0)) * (h.probability - (acts ? 1.0 : 0.0));
            if (best == nullptr || h.probability > best->probability) best = &h;
        }
        if (!listed) brier += 1.0, all.add(0.0, true);
        top.add(best->probability, best->effects == j.truth);
    }
    Calibration c{all.error(), top.error(), n > 0 ? brier / n : 0.0};
    for (int k = 0; k < bins; ++k)
        if (all.count[k] > 0)
            c.bins.push_back(
                {all.probability[k] / all.count[k], all.frequency[k] / all.count[k], all.count[k]});
    return c;
}

std::string text(const ScoreTable& table) {
    std::string out = fmt::format("{} cases, {} without a verdict\n\n", table.cases, table.missing);
    for (const Line& line : table.lines) {
        const std::string met = line.met ? (*line.met ? "met" : "NOT met") : "";
        const std::string bounds =
            line.bounds ? fmt::format("{:.3f}-{:.3f}", line.bounds->low, line.bounds->high) : "";
        out += fmt::format("{:<58} {:>8} {:>13}  n {:<5} {:<24} {:<8}{}\n", line.figure,
                           line.count > 0 ? fmt::format("{:.3f}", line.value) : "-", bounds,
                           line.count, line.bar, met, line.note);
    }
    out += "\nWhat was concealed (D >= 5), how often, what was named:\n" + matrix(table.confusion);
    out += fmt::format(
        "\nProbabilities: calibration error {:.3f} over hypotheses, {:.3f} over the most probable "
        "ones; Brier score {:.3f}\n  told   came true   of\n",
        table.calibration.expected_error, table.calibration.expected_error_top,
        table.calibration.brier);
    for (const Calibration::Bin& b : table.calibration.bins)
        out += fmt::format("  {:.3f}  {:.3f}       {}\n", b.probability, b.frequency, b.count);
    return out;
}

}  // namespace prove
