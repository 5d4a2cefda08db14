// SPDX-License-Identifier: MIT
#include "calibrate/problem.hpp"

#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

namespace calibrate {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using scaling::InvalidParameter;
using scaling::mistake;

// Points that agree to this share of a range are one point: text files round.
constexpr double same_place = 1e-9;

const Factor& factor(const Problem& p, Index k) { return p.factors[static_cast<std::size_t>(k)]; }

bool same_point(const Problem& p, const VectorXd& a, const VectorXd& b) {
    return (coded(p, a) - coded(p, b)).cwiseAbs().maxCoeff() < same_place;
}

}  // namespace

VectorXd coded(const Problem& p, const VectorXd& point) {
    VectorXd c(point.size());
    for (Index k = 0; k < c.size(); ++k) {
        const Factor& f = factor(p, k);
        const double share = f.logarithmic ? std::log(point[k] / f.low) / std::log(f.high / f.low)
                                           : (point[k] - f.low) / (f.high - f.low);
        c[k] = 2.0 * share - 1.0;
    }
    return c;
}

VectorXd point_of(const Problem& p, const VectorXd& coded) {
    VectorXd point(coded.size());
    for (Index k = 0; k < point.size(); ++k) {
        const Factor& f = factor(p, k);
        const double share = 0.5 * (coded[k] + 1.0);
        point[k] = f.logarithmic ? f.low * std::pow(f.high / f.low, share)
                                 : f.low + share * (f.high - f.low);
    }
    return point;
}

void check(const Problem& p) {
    if (p.factors.empty())
        throw InvalidParameter(mistake("factors", "none", "must hold at least one",
                                       "name what may be turned and its range"));
    for (const Factor& f : p.factors) {
        const std::string range = fmt::format("{} to {} {}", f.low, f.high, f.unit);
        if (!(f.low < f.high) || !std::isfinite(f.low) || !std::isfinite(f.high))
            throw InvalidParameter(
                mistake("factors." + f.name, range, "low must be below high", "state a range"));
        if (f.logarithmic && !(f.low > 0.0))
            throw InvalidParameter(mistake("factors." + f.name, range, "must begin above 0",
                                           "a logarithm has no zero; or make it linear"));
    }
    if (p.targets.empty() || !p.targets.front().value)
        throw InvalidParameter(mistake("targets", std::to_string(p.targets.size()) + " targets",
                                       "the first must have been measured", "give its value"));
    for (const Target& t : p.targets)
        if (!(t.standard_deviation > 0.0) || (t.value && !std::isfinite(*t.value)))
            throw InvalidParameter(mistake(
                "targets." + t.name,
                fmt::format("{} +- {} {}", t.value.value_or(0.0), t.standard_deviation, t.unit),
                "must be finite with a standard deviation > 0",
                "no measurement is exact: state how far its mean may be off"));
}

void check(const Problem& p, const std::vector<Run>& history) {
    check(p);
    std::set<std::uint64_t> seeds;
    for (const Run& run : history) {
        const std::string where = fmt::format("history[seed {}]", run.request.seed);
        if (!seeds.insert(run.request.seed).second)
            throw InvalidParameter(mistake(where, "twice", "must be there once", "drop one"));
        if (run.request.seed < p.seed)
            throw InvalidParameter(mistake(where, "a seed below that of the problem",
                                           fmt::format("must be >= {}", p.seed),
                                           "is it of another campaign?"));
        if (run.request.point.size() != static_cast<Index>(p.factors.size()) ||
            !run.request.point.allFinite())
            throw InvalidParameter(
                mistake(where, std::to_string(run.request.point.size()) + " numbers",
                        "must be one finite number for each factor", "is it of another campaign?"));
        if (!run.values) continue;
        bool finite = run.values->size() == p.targets.size();
        for (const double v : *run.values) finite = finite && std::isfinite(v);
        if (!finite)
            throw InvalidParameter(mistake(where, std::to_string(run.values->size()) + " values",
                                           "must be one finite value for each target",
                                           "a run without a heap has no values at all"));
    }
}

const Run* find_run(const Problem& p, const std::vector<Run>& history, std::size_t number,
                    const VectorXd& point) {
    for (const Run& run : history) {
        if (run.request.seed != p.seed + number) continue;
        if (!same_point(p, run.request.point, point))
            throw InvalidParameter(mistake(fmt::format("history[seed {}]", run.request.seed),
                                           "another point than this campaign asks for",
                                           "must be of the same problem and options",
                                           "start a new campaign"));
        return &run;
    }
    return nullptr;
}

std::optional<Scatter> scatter(const Problem& p, const std::vector<Run>& history,
                               std::size_t target) {
    double squares = 0.0;
    int freedom = 0;
    std::vector<bool> counted(history.size(), false);
    for (std::size_t i = 0; i < history.size(); ++i) {
        if (counted[i] || !history[i].values) continue;
        double sum = 0.0, sum2 = 0.0;
        int count = 0;
        const double about = (*history[i].values)[target];
        for (std::size_t j = i; j < history.size(); ++j) {
            if (!history[j].values ||
                !same_point(p, history[i].request.point, history[j].request.point))
                continue;
            const double off = (*history[j].values)[target] - about;
            counted[j] = true, sum += off, sum2 += off * off, ++count;
        }
        squares += sum2 - sum * sum / count;
        freedom += count - 1;
    }
    if (freedom == 0) return std::nullopt;
    return Scatter{std::sqrt(std::max(squares, 0.0) / freedom), freedom};
}

}  // namespace calibrate
