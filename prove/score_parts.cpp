// SPDX-License-Identifier: MIT
#include "prove/score_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace prove::score_parts {
namespace {

const Verdict* find(const Verdicts& verdicts, const std::string& name) {
    const auto found = verdicts.find(name);
    return found == verdicts.end() ? nullptr : &found->second;
}

std::string joined(const std::vector<std::string>& names) {
    std::string all;
    for (const std::string& n : names) all += (all.empty() ? "" : " + ") + n;
    return all.empty() ? "none" : all;
}

double median(std::vector<double> values) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    return n % 2 == 1 ? values[n / 2] : 0.5 * (values[n / 2 - 1] + values[n / 2]);
}

bool clear(const Judged& j) {
    return (j.key->kind == Kind::single || j.key->kind == Kind::look_alike) &&
           j.key->separation.d >= 5.0;
}

std::map<std::string, Tally> recalls(const std::vector<Judged>& all) {
    std::map<std::string, Tally> by_effect;
    for (const Judged& j : all) {
        if (!clear(j)) continue;
        Tally& t = by_effect[j.truth.front()];
        ++t.count;
        t.hits += j.right() ? 1 : 0;
    }
    return by_effect;
}

// What a person would read off the verdict.
std::string answer(const Judged& j) {
    if (j.verdict == nullptr) return "missing";
    if (!j.named.empty()) return joined(j.named);
    if (j.verdict->verdict == "unexplained") return "unknown";
    if (j.verdict->verdict == "explained") return "none";
    return j.verdict->verdict;
}

// The channel that holds most of the squares.
std::string true_channel(const Key& k) {
    std::map<std::string, double> shares;
    for (const TrueInterval& i : k.intervals) shares[i.channel] += i.share;
    std::string best;
    for (const auto& [channel, share] : shares)
        if (best.empty() || share > shares[best]) best = channel;
    return best;
}

double best_overlap(const Judged& j) {
    double best = 0.0;
    for (const JudgedPlace& p : j.verdict->located)
        for (const TrueInterval& i : j.key->intervals)
            if (p.experiment == i.experiment && p.channel == i.channel && p.variable == i.ordinate)
                best = std::max(best, overlap_over_union(p.from, p.to, i.from, i.to));
    return best;
}

// Size of a parameter against which an error counts: its distance from the value at which the effect is absent.
double size_of(const TrueParameter& p) {
    if (p.name == "scale" || p.name == "factor") return std::abs(p.value - 1.0);
    if (p.name == "phase" || p.name == "tilt_azimuth") return std::numbers::pi;
    return std::abs(p.value);
}

double error_of(const TrueParameter& p, double value) {
    const double off = value - p.value;
    const bool angle = p.name == "phase" || p.name == "tilt_azimuth";
    // The sign of a charge does not act on an earthed plate.
    if (p.name == "charge") return std::abs(std::abs(value) - std::abs(p.value));
    return std::abs(angle ? std::remainder(off, 2.0 * std::numbers::pi) : off);
}

}  // namespace

bool Judged::right() const { return verdict != nullptr && named == truth; }

bool Judged::wrong() const {
    if (verdict == nullptr) return true;
    return std::any_of(named.begin(), named.end(), [&](const std::string& n) {
        return std::find(truth.begin(), truth.end(), n) == truth.end();
    });
}

bool Judged::right_after() const { return after != nullptr && after->named() == truth; }

bool Judged::ambiguous_with_truth() const {
    if (verdict == nullptr || verdict->verdict != "ambiguous") return false;
    const std::string name = joined(truth);
    if (std::find(verdict->between.begin(), verdict->between.end(), name) != verdict->between.end())
        return true;
    return std::any_of(
        verdict->hypotheses.begin(), verdict->hypotheses.end(),
        [&](const Hypothesis& h) { return h.effects == truth && h.probability >= 0.05; });
}

Line share(const char* figure, const char* bar, const Tally& t, double least, double most) {
    Line line{figure, bar};
    line.count = t.count;
    line.bounds = wilson(t.hits, t.count);
    if (t.count == 0) return line;
    line.value = static_cast<double>(t.hits) / t.count;
    if (least > 0.0 || most < 1.0) line.met = line.value >= least && line.value <= most;
    return line;
}

std::vector<Judged> judged(const Keys& keys, const Verdicts& first, const Verdicts* after) {
    std::vector<Judged> all;
    for (const auto& [name, key] : keys) {
        Judged j{&key,
                 find(first, name),
                 after == nullptr ? nullptr : find(*after, name),
                 key.effects,
                 {}};
        std::sort(j.truth.begin(), j.truth.end());
        if (j.verdict != nullptr) j.named = j.verdict->named();
        all.push_back(std::move(j));
    }
    return all;
}

Line macro_recall(const std::vector<Judged>& all) {
    Line line{"  mean of the recalls of the effects", ""};
    const auto by_effect = recalls(all);
    for (const auto& [effect, t] : by_effect) line.value += static_cast<double>(t.hits) / t.count;
    line.count = static_cast<int>(by_effect.size());
    if (line.count > 0) line.value /= line.count;
    return line;
}

Line least_recall(const std::vector<Judged>& all) {
    Line line{"  least recall of an effect, D >= 5", ">= 80 %"};
    line.value = 1.0;
    for (const auto& [effect, t] : recalls(all)) {
        const double recall = static_cast<double>(t.hits) / t.count;
        line.note +=
            fmt::format("{}{} {}/{}", line.note.empty() ? "" : ", ", effect, t.hits, t.count);
        if (recall > line.value) continue;
        line.value = recall;
        line.count = t.count;
        line.bounds = wilson(t.hits, t.count);
    }
    if (line.count > 0) line.met = line.value >= 0.8;
    return line;
}

Line worst_pair(const std::vector<Judged>& all) {
    Line line{"  most frequent wrong pair, D >= 5", "<= 8 %"};
    std::map<std::string, int> counts;
    std::map<std::pair<std::string, std::string>, int> wrong;
    for (const Judged& j : all) {
        if (!clear(j)) continue;
        ++counts[j.truth.front()];
        for (const std::string& n : j.named)
            if (n != j.truth.front()) ++wrong[{j.truth.front(), n}];
    }
    for (const auto& [effect, n] : counts) line.count = std::max(line.count, n);
    for (const auto& [pair, n] : wrong) {
        const double share = static_cast<double>(n) / counts[pair.first];
        if (share < line.value) continue;
        line.value = share;
        line.count = counts[pair.first];
        line.bounds = wilson(n, line.count);
        line.note = pair.first + " called " + pair.second;
    }
    if (!counts.empty()) line.met = line.value <= 0.08;
    return line;
}

Confusion confusion(const std::vector<Judged>& all) {
    Confusion matrix;
    for (const Judged& j : all)
        if (clear(j) || (j.key->kind != Kind::single && j.key->kind != Kind::look_alike))
            ++matrix[j.key->kind == Kind::pair ? "two effects" : joined(j.truth)]
                    [j.key->kind == Kind::pair && j.right() ? "both" : answer(j)];
    return matrix;
}

double overlap_over_union(double a, double b, double c, double d) {
    if (a > b) std::swap(a, b);
    if (c > d) std::swap(c, d);
    const double both = std::max(0.0, std::min(b, d) - std::max(a, c));
    const double either = std::max(b, d) - std::min(a, c);
    return either > 0.0 && std::isfinite(either) ? both / either : 0.0;
}

void places(const std::vector<Judged>& all, std::vector<Line>& lines) {
    Tally channel;
    std::vector<double> overlaps;
    for (const Judged& j : all) {
        if (j.key->intervals.empty() || j.key->lambda < 25.0 || j.key->kind == Kind::numerical)
            continue;
        if (j.verdict == nullptr || !j.verdict->alarm()) continue;
        overlaps.push_back(best_overlap(j));
        if (j.key->recorded_channels < 2) continue;
        ++channel.count;
        const bool right = !j.verdict->located.empty() &&
                           j.verdict->located.front().channel == true_channel(*j.key);
        channel.hits += right ? 1 : 0;
    }
    Line line{"right channel, two or more channels", ">= 97 %"};
    line.count = channel.count;
    line.bounds = wilson(channel.hits, channel.count);
    if (channel.count > 0) {
        line.value = static_cast<double>(channel.hits) / channel.count;
        line.met = line.value >= 0.97;
    }
    lines.push_back(line);
    Line overlap{"overlap over union with the true interval, median", ">= 0.7"};
    overlap.count = static_cast<int>(overlaps.size());
    overlap.value = median(overlaps);
    if (overlap.count > 0) overlap.met = overlap.value >= 0.7;
    lines.push_back(overlap);
}

void parameters(const std::vector<Judged>& all, std::vector<Line>& lines) {
    std::vector<double> errors;
    Tally held;
    for (const Judged& j : all) {
        if (j.verdict == nullptr) continue;
        for (const TrueParameter& p : j.key->parameters) {
            for (const JudgedEffect& e : j.verdict->effects) {
                if (e.name != p.effect) continue;
                for (const Estimate& estimate : e.parameters) {
                    if (estimate.name != p.name) continue;
                    const double allowed = std::max(0.08 * size_of(p), 1.5 * p.oracle_error);
                    if (j.right() && std::isfinite(estimate.value))
                        errors.push_back(error_of(p, estimate.value) / allowed);
                    if (!std::isfinite(estimate.low) || !std::isfinite(estimate.high)) continue;
                    ++held.count;
                    held.hits += p.value >= estimate.low && p.value <= estimate.high ? 1 : 0;
                }
            }
        }
    }
    Line line{"parameters: error over max(8 %, 1.5 oracle errors), median", "<= 1"};
    line.count = static_cast<int>(errors.size());
    line.value = median(errors);
    if (line.count > 0) line.met = line.value <= 1.0;
    lines.push_back(line);
    Line interval{"90 % intervals that hold the truth", "86-94 %, >= 300 of them"};
    interval.count = held.count;
    interval.bounds = wilson(held.hits, held.count);
    if (held.count > 0) {
        interval.value = static_cast<double>(held.hits) / held.count;
        interval.met = interval.value >= 0.86 && interval.value <= 0.94 && held.count >= 300;
    }
    lines.push_back(interval);
}

void stability(const Keys& keys, const Judgements& judgements, std::vector<Line>& lines) {
    if (judgements.other_seeds.empty()) return;
    Tally same;
    for (const Judged& j : judged(keys, judgements.first)) {
        if (!clear(j) || j.verdict == nullptr) continue;
        for (const Verdicts& other : judgements.other_seeds) {
            const Verdict* v = find(other, j.key->name);
            if (v == nullptr) continue;
            ++same.count;
            same.hits += v->verdict == j.verdict->verdict && v->named() == j.named ? 1 : 0;
        }
    }
    Line line{"same verdict over other seeds of the judge, D >= 5", ">= 95 %"};
    line.count = same.count;
    line.bounds = wilson(same.hits, same.count);
    if (same.count > 0) {
        line.value = static_cast<double>(same.hits) / same.count;
        line.met = line.value >= 0.95;
    }
    lines.push_back(line);
}

}  // namespace prove::score_parts
