// SPDX-License-Identifier: MIT
#include "calibrate/paper_road.hpp"

#include "calibrate/designs.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace calibrate {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

struct Missing {};  // thrown where the road cannot go on without a run; caught in next()

struct Done {
    VectorXd point;
    std::optional<double> value;  // of the first target; nothing: no heap
};

// The road is walked from its beginning each time; runs that are not there yet become requests.
class Walk {
  public:
    Walk(const Problem& p, const PaperOptions& o, const std::vector<Run>& history)
        : problem_(p), options_(o), history_(history), target_(*p.targets.front().value) {
        for (std::size_t k = 0; k < p.factors.size(); ++k) {
            const Factor& f = p.factors[k];
            const bool twice = f.low > 0.0 && 2.0 * f.low < f.high;
            levels_.push_back({f.low, twice ? 2.0 * f.low : 0.5 * (f.low + f.high)});
            if (!o.screening_levels.empty()) levels_[k] = o.screening_levels.at(k);
        }
    }

    PaperStep go() {
        try {
            screen();
            climb();
        } catch (const Missing&) {
            return {requests_, std::nullopt};
        }
        result_.runs = static_cast<int>(done_.size());
        return {{}, result_};
    }

  private:
    std::vector<Done> run(const std::vector<VectorXd>& points, const std::string& stage);
    void screen();
    void climb();
    std::vector<Done> ascend(std::size_t factors);
    void refine(const std::vector<Done>& ascent);
    void interpolate(const std::vector<Done>& grid, const std::vector<Done>& ascent);
    void confirm();
    void say(std::string note) { result_.notes.push_back(std::move(note)); }
    double error(const Done& d) const { return std::abs(*d.value - target_); }
    bool passes(const std::vector<Done>& list) const;

    const Problem& problem_;
    const PaperOptions& options_;
    const std::vector<Run>& history_;
    double target_;
    std::vector<std::array<double, 2>> levels_;  // [factors]
    std::vector<std::size_t> order_;             // factors, strongest first
    std::vector<double> effects_;                // [factors]
    double want_ = 1.0;                          // +1: the target lies above the screening
    std::vector<Done> done_;                     // by number
    std::vector<Request> requests_;
    PaperResult result_;
};

std::vector<Done> Walk::run(const std::vector<VectorXd>& points, const std::string& stage) {
    std::vector<Done> list;
    for (const VectorXd& point : points) {
        const auto before = std::find_if(done_.begin(), done_.end(),
                                         [&](const Done& d) { return d.point == point; });
        if (stage == "orthogonal" && before != done_.end()) {
            list.push_back(*before);
            continue;
        }
        const Run* found = find_run(problem_, history_, done_.size(), point);
        if (!found) requests_.push_back({point, problem_.seed + done_.size(), stage});
        done_.push_back({point, std::nullopt});
        if (found && found->values) done_.back().value = found->values->front();
        list.push_back(done_.back());
    }
    if (!requests_.empty()) throw Missing{};
    return list;
}

bool Walk::passes(const std::vector<Done>& list) const {
    bool under = false, over = false;
    for (const Done& d : list) {
        if (!d.value) continue;
        under = under || *d.value <= target_;
        over = over || *d.value >= target_;
    }
    return under && over;
}

int plackett_burman_runs(std::size_t factors) {
    for (const int runs : {12, 16, 20, 24, 36})
        if (factors < static_cast<std::size_t>(runs)) return runs;
    throw scaling::InvalidParameter(scaling::mistake("factors", std::to_string(factors),
                                                     "must be at most 35 on the paper's road",
                                                     "leave some out"));
}

void Walk::screen() {
    const std::size_t factors = problem_.factors.size();
    const Eigen::MatrixXd design = plackett_burman(plackett_burman_runs(factors));
    std::vector<VectorXd> points;
    for (Index r = 0; r < design.rows(); ++r) {
        points.emplace_back(static_cast<Index>(factors));
        for (std::size_t k = 0; k < factors; ++k)
            points.back()[static_cast<Index>(k)] =
                levels_[k][design(r, static_cast<Index>(k)) > 0.0 ? 1 : 0];
    }
    const std::vector<Done> runs = run(points, "screening");
    std::array<double, 2> sum{}, count{};
    for (std::size_t k = 0; k < factors; ++k) {
        sum = count = {0.0, 0.0};
        for (std::size_t r = 0; r < runs.size(); ++r) {
            if (!runs[r].value) continue;
            const bool high = design(static_cast<Index>(r), static_cast<Index>(k)) > 0.0;
            sum[high] += *runs[r].value, count[high] += 1.0;
        }
        const bool both = count[0] > 0.0 && count[1] > 0.0;
        effects_.push_back(both ? sum[1] / count[1] - sum[0] / count[0] : 0.0);
    }
    const double formed = count[0] + count[1];
    if (formed < static_cast<double>(runs.size()))
        say(
            fmt::format("{} of {} screening runs formed no heap and were dropped: effects may no "
                        "longer have a unique value",
                        static_cast<double>(runs.size()) - formed, runs.size()));
    if (formed > 0.0) want_ = target_ >= (sum[0] + sum[1]) / formed ? 1.0 : -1.0;
    order_.resize(factors);
    std::iota(order_.begin(), order_.end(), 0U);
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
        return std::abs(effects_[a]) > std::abs(effects_[b]);
    });
    for (const std::size_t k : order_)
        result_.ranking.push_back({problem_.factors[k].name, effects_[k]});
}

// The strongest `factors` move from a screening level to the end of the range.
std::vector<Done> Walk::ascend(std::size_t factors) {
    constexpr int steps = 5;
    VectorXd from(static_cast<Index>(levels_.size())), to(from.size());
    for (std::size_t k = 0; k < levels_.size(); ++k)
        from[static_cast<Index>(k)] = to[static_cast<Index>(k)] =
            0.5 * (levels_[k][0] + levels_[k][1]);
    for (std::size_t n = 0; n < factors; ++n) {
        const std::size_t k = order_[n];
        const Factor& f = problem_.factors[k];
        const bool up = want_ * effects_[k] >= 0.0;
        const double end = up ? f.high : f.low, near = levels_[k][up ? 1 : 0];
        // From the level that lies ahead, or from the other one where that is the end already.
        from[static_cast<Index>(k)] = near == end ? levels_[k][up ? 0 : 1] : near;
        to[static_cast<Index>(k)] = end;
    }
    std::vector<Done> path;
    for (int n = 0; n <= steps; ++n) {
        const bool two_missing = n >= 3 && !path.back().value && !path[path.size() - 2].value;
        const std::vector<Done> but_last(path.begin(), path.empty() ? path.end() : path.end() - 1);
        if (two_missing || (n >= 3 && passes(but_last))) break;
        path.push_back(run({from + (to - from) * n / steps}, "ascent").front());
    }
    return path;
}

void Walk::climb() {
    const std::size_t strongest = std::min<std::size_t>(3, order_.size());
    std::vector<Done> path = ascend(strongest);
    const bool missing =
        std::any_of(path.begin(), path.end(), [](const Done& d) { return !d.value; });
    if (strongest == 3 && missing && !passes(path)) {
        say(
            fmt::format("the ascent of three factors met runs without a heap before the target: {} "
                        "stays at the middle of its levels",
                        problem_.factors[order_[2]].name));
        path = ascend(2);
    }
    if (order_.size() < 2) return interpolate({}, path), confirm();
    refine(path);
    confirm();
}

void Walk::refine(const std::vector<Done>& path) {
    std::size_t centre = path.size();
    for (std::size_t k = 0; k < path.size(); ++k)
        if (path[k].value && (centre == path.size() || error(path[k]) < error(path[centre])))
            centre = k;
    if (centre == path.size()) return say("no heap formed on the ascent");
    const std::size_t middle = std::clamp<std::size_t>(centre, 1, path.size() - 2);
    const auto a = static_cast<Index>(order_[0]), b = static_cast<Index>(order_[1]);
    std::vector<VectorXd> points;
    for (std::size_t i = middle - 1; i <= middle + 1; ++i)
        for (std::size_t j = middle - 1; j <= middle + 1; ++j) {
            points.push_back(path[centre].point);
            points.back()[a] = path[i].point[a], points.back()[b] = path[j].point[b];
        }
    interpolate(run(points, "orthogonal"), path);
}

void Walk::interpolate(const std::vector<Done>& grid, const std::vector<Done>& path) {
    const Done *first = nullptr, *second = nullptr;
    const auto consider = [&](const Done& x, const Done& y) {
        if (!x.value || !y.value || (*x.value - target_) * (*y.value - target_) > 0.0) return;
        if (*x.value == *y.value) return;
        if (!first || error(x) + error(y) < error(*first) + error(*second)) first = &x, second = &y;
    };
    for (std::size_t k = 0; k < grid.size(); ++k) {
        if (k % 3 < 2) consider(grid[k], grid[k + 1]);
        if (k < 6) consider(grid[k], grid[k + 3]);
    }
    if (!first)
        for (std::size_t k = 0; k + 1 < path.size(); ++k) consider(path[k], path[k + 1]);
    if (!first) {
        for (const Done& d : done_)
            if (d.value && (!first || error(d) < error(*first))) first = &d;
        if (!first) return;
        say("no two neighbours lie on both sides of the target: the nearest run is taken");
        result_.answer = first->point, result_.predicted = first->value;
        return;
    }
    result_.passed = true;
    const double share = (target_ - *first->value) / (*second->value - *first->value);
    const VectorXd way = second->point - first->point;
    result_.answer = first->point + share * way;
    result_.predicted = target_;
    Index k = 0;
    if (way.cwiseAbs().maxCoeff(&k) > 0.0 && (way.array() != 0.0).count() == 1) {
        const double slope = (*second->value - *first->value) / way[k];
        result_.line = Line{problem_.factors[static_cast<std::size_t>(k)].name, slope,
                            *first->value - slope * first->point[k]};
    }
}

void Walk::confirm() {
    if (!result_.answer) return say("no heap formed: there is nothing to confirm");
    const std::vector<VectorXd> points(static_cast<std::size_t>(options_.confirmations),
                                       *result_.answer);
    for (const Done& d : run(points, "confirming"))
        if (d.value) result_.confirmed.push_back(*d.value);
    if (result_.confirmed.size() < points.size())
        say(fmt::format("{} of {} confirming runs formed no heap",
                        points.size() - result_.confirmed.size(), points.size()));
}

}  // namespace

int most_runs(const Problem& p, const PaperOptions& o) {
    constexpr int ascent = 6, grid_without_its_centre = 8;
    return plackett_burman_runs(p.factors.size()) + 2 * ascent + grid_without_its_centre +
           o.confirmations;
}

PaperStep next(const Problem& p, const PaperOptions& o, const std::vector<Run>& history) {
    check(p, history);
    if (!o.screening_levels.empty() && o.screening_levels.size() != p.factors.size())
        throw scaling::InvalidParameter(
            scaling::mistake("screening_levels", std::to_string(o.screening_levels.size()),
                             "must be one pair for each factor", "or none at all"));
    if (o.confirmations < 0)
        throw scaling::InvalidParameter(scaling::mistake(
            "confirmations", std::to_string(o.confirmations), "must be >= 0", "0: none"));
    return Walk(p, o, history).go();
}

}  // namespace calibrate
