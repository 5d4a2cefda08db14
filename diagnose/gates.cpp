// SPDX-License-Identifier: MIT
#include "diagnose/gates.hpp"

#include "cases/rig_table.hpp"
#include "diagnose/words.hpp"

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace diagnose {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double deviations = 3.3;  // two-sided 1 in 1000

// Place of the term's first unknown in the winner's list; -1 where it has none.
Index place_of(const Candidate& c, std::size_t which) {
    Index at = static_cast<Index>(c.h.unknowns.size());
    for (std::size_t k = c.h.terms.size(); k-- > which;)
        at -= static_cast<Index>(c.h.terms[k]->unknowns.size());
    return c.h.terms[which]->unknowns.empty() ? -1 : at;
}

Gate range_gate(const GateInput& in, std::size_t which) {
    const Term& term = *in.winner.h.terms[which];
    const Index at = place_of(in.winner, which);
    if (at < 0)
        return {"range", GateResult::passed,
                "It has no parameter of its own: its strength follows from the case."};
    const Unknown& x = in.winner.h.unknowns[static_cast<std::size_t>(at)];
    const double u = to_u(in.winner.h.unknowns, in.winner.fit.theta)[at];
    // At an end a value fails only where the recordings push it further: by the drop in chi squared of a step across.
    const bool ends = x.prior != Prior::gaussian && (u < 0.01 || u > 0.99);
    const double slope = in.winner.fit.jacobian.col(at).dot(in.winner.fit.white);
    const double across = in.winner.fit.covariance(at, at) * slope * slope;
    const bool beyond = ends && (u > 0.5) == (slope > 0.0) && across > deviations * deviations;
    return {"range", beyond ? GateResult::failed : GateResult::passed,
            fmt::format("{} = {}{}, {} the physical range {} to {}{}.", x.name,
                        cases::format_si(in.winner.fit.theta[at], x.unit),
                        term.effect == "air_drag" ? " (factor on the drag curve of a sphere)" : "",
                        ends ? "at the end of" : "inside", cases::format_si(x.low, x.unit),
                        cases::format_si(x.high, x.unit),
                        beyond ? "; these recordings ask for more"
                        : ends ? "; nothing in these recordings pushes it beyond"
                               : "")};
}

// Drop in chi squared when `columns` (whitened) may move, too, at first order.
double gain_of(const Fit& f, const MatrixXd& columns) {
    MatrixXd all(f.jacobian.rows(), f.jacobian.cols() + columns.cols());
    all << f.jacobian, columns;
    MatrixXd normal = all.transpose() * all;
    normal.diagonal().array() += 1e-9 * (1.0 + normal.diagonal().array());
    const VectorXd g = all.transpose() * f.white;
    MatrixXd few = f.jacobian.transpose() * f.jacobian;
    few.diagonal().array() += 1e-9 * (1.0 + few.diagonal().array());
    const VectorXd g_few = f.jacobian.transpose() * f.white;
    return g.dot(normal.ldlt().solve(g)) -
           (few.rows() > 0 ? g_few.dot(few.ldlt().solve(g_few)) : 0.0);
}

// Sensitivity to the strength, by recording; those that see it at all.
std::vector<VectorXd> sensitive(const GateInput& in, Index at) {
    std::vector<VectorXd> columns;
    for (std::size_t k = 0; k < in.problem.records.size(); ++k) {
        VectorXd part = rows_of(in.problem, k, in.winner.fit.jacobian.col(at));
        const double error = std::sqrt(in.winner.fit.covariance(at, at));
        if (part.norm() * error > 0.1) columns.push_back(std::move(part));
    }
    return columns;
}

Gate regimes_gate(const GateInput& in, std::size_t which) {
    const Index at = place_of(in.winner, which);
    if (at < 0)
        return {"regimes", GateResult::untestable, "Nothing to compare: it has no parameter."};
    const std::vector<VectorXd> columns = sensitive(in, at);
    if (columns.size() < 2)
        return {"regimes", GateResult::untestable,
                "Fewer than two recordings show this effect: its parameter cannot be found twice."};
    const auto free = static_cast<Index>(columns.size()) - 1;
    MatrixXd m(columns.front().size(), free);
    for (Index k = 0; k < free; ++k) m.col(k) = columns[static_cast<std::size_t>(k)];
    const double gain = gain_of(in.winner.fit, m);
    const bool same = normal_of_squares(gain, static_cast<double>(free)) < deviations;
    return {"regimes", same ? GateResult::passed : GateResult::failed,
            fmt::format("One value {} {} recordings (chi squared {:.1f} for {} differences).",
                        same ? "serves all" : "does not serve all", columns.size(), gain, free)};
}

// Conditions and grain of an experiment as numbers.
std::map<std::string, double> described(const cases::Experiment& e) {
    std::map<std::string, double> d{{"grain.diameter", e.grain.diameter.value.value()},
                                    {"grain.density", e.grain.density.value.value()}};
    for (const cases::Condition& rule : cases::rig_rule(e.rig).conditions)
        if (!rule.unit.empty() && e.conditions.has(rule.name) &&
            e.conditions.at(rule.name).kind != cases::Value::Kind::list)
            try {
                d[rule.name] =
                    e.conditions.at(rule.name).si(cases::parse_unit(rule.unit, rule.name));
            } catch (const std::exception&) {
                // a word such as "instant"
            }
    return d;
}

Gate scaling_gate(const GateInput& in, std::size_t which) {
    const Index at = place_of(in.winner, which);
    std::map<std::string, std::vector<double>> values;
    for (const Record& r : in.problem.records)
        for (const auto& [key, value] : described(*r.experiment)) values[key].push_back(value);
    std::string worst, seen;
    double largest = 0.0;
    for (const auto& [key, list] : values) {
        if (at < 0 || list.size() != in.problem.records.size()) continue;
        double mean = 0.0, spread = 0.0;
        for (const double v : list) mean += v / static_cast<double>(list.size());
        for (const double v : list) spread = std::max(spread, std::abs(v - mean));
        if (spread <= 0.02 * std::abs(mean)) continue;
        MatrixXd m = MatrixXd::Zero(in.winner.fit.jacobian.rows(), 1);
        int informed = 0;
        for (std::size_t k = 0; k < list.size(); ++k) {
            const VectorXd part = rows_of(in.problem, k, in.winner.fit.jacobian.col(at));
            informed += part.norm() * std::sqrt(in.winner.fit.covariance(at, at)) > 0.1 ? 1 : 0;
            m.col(0) += (list[k] - mean) / spread * part;
        }
        if (informed < 2) continue;
        seen += (seen.empty() ? "" : ", ") + key;
        const double z = std::sqrt(std::max(0.0, gain_of(in.winner.fit, m)));
        if (z > largest) largest = z, worst = key;
    }
    if (seen.empty())
        return {"scaling", GateResult::untestable,
                "No condition varies among the recordings that show this effect."};
    const bool same = largest < deviations;
    return {"scaling", same ? GateResult::passed : GateResult::failed,
            same ? fmt::format("Its parameter stays the same where {} changes.", seen)
                 : fmt::format("Its parameter would have to drift with {} ({:.1f} sigma).", worst,
                               largest)};
}

// Rows of one branch of a force curve, first and number; else all: a curve run backwards as a whole would be itself.
std::vector<std::pair<Index, Index>> branches(const Record& r, const Channel& c) {
    std::vector<std::pair<Index, Index>> list;
    const auto all = static_cast<Index>(c.recorded.size());
    for (Index k = 0, from = 0; k < all; ++k) {
        const auto at = static_cast<std::size_t>(k);
        const bool ends = k + 1 == all || (!r.ordinates.retract.empty() &&
                                           r.ordinates.retract[at] != r.ordinates.retract[at + 1]);
        if (ends) list.push_back({from, k + 1 - from}), from = k + 1;
    }
    return list;
}

// The effect's own signature turned around in time or space, recording by recording: the same freedom, the wrong physics.
Gate placebo_gate(const GateInput& in, std::size_t which) {
    const Projection project(in.base.h.unknowns, in.base.fit);
    const VectorXd d = in.whiten(in.winner.fit.prediction - in.base.fit.prediction);
    const VectorXd left = project(in.base.fit.white), own = project(d);
    const double gain = in.base.fit.objective() - in.winner.fit.objective();
    constexpr double told_apart =
        36.0;  // drop in chi squared by which the two are to differ, 6 sigma
    double best = 0.0;
    bool any = false;
    for (const bool swapped : {false, true}) {
        VectorXd placebo = VectorXd::Zero(d.size());
        std::size_t sign = 0;
        for (const Record& r : in.problem.records)
            for (const Channel& c : r.channels)
                for (const auto& [from, n] : branches(r, c)) {
                    const Index first = static_cast<Index>(c.first) + from;
                    for (Index k = 0; k < n; ++k)
                        placebo[first + k] =
                            swapped ? d[first + (k + n / 2) % n] * (sign % 2 ? -1.0 : 1.0)
                                    : d[first + n - 1 - k];
                    ++sign;
                }
        for (std::size_t k = 0; k < in.whiten.measured().size(); ++k)
            if (!in.whiten.measured()[k]) placebo[static_cast<Index>(k)] = 0.0;
        placebo = project(placebo);
        const double size = placebo.norm();
        if (size == 0.0) continue;
        // One that comes out as the signature itself (an offset run backwards is an offset) is no test.
        const double alike = own.dot(placebo) / (size * own.norm());
        if ((1.0 - alike * alike) * gain < told_apart) continue;
        any = true;
        best = std::max(best, std::pow(std::max(0.0, placebo.dot(left) / size), 2));
    }
    if (!any)
        return {
            "placebo", GateResult::untestable,
            "Run backwards or shifted its signature is the same, to what these recordings show."};
    const bool better = gain > best + 4.0;
    return {"placebo", better ? GateResult::passed : GateResult::failed,
            fmt::format("{} lowers chi squared by {:.0f}; the same signature run backwards or "
                        "shifted by {:.0f}.",
                        plain_name(in.winner.h.terms[which]->effect), gain, best)};
}

Gate refinement_gate(const GateInput& in, std::size_t which) {
    if (in.winner.h.terms[which]->effect == "numerical_artefact")
        return {"refinement", GateResult::passed,
                "A finer time step removes the mismatch: that is what it is."};
    if (!std::isfinite(in.refined_base_p_value))
        return {"refinement", GateResult::passed,
                "The user's run is resolved: a finer step changes nothing that shows here."};
    const bool stays = in.refined_base_p_value < own_level;
    return {"refinement", stays ? GateResult::passed : GateResult::failed,
            stays ? "The mismatch stays when the user's model is run with a fine time step."
                  : "The mismatch goes when the user's model is run with a fine time step."};
}

}  // namespace

std::vector<Gate> gates(const GateInput& in, std::size_t which) {
    const bool clean = in.own_p_value >= own_level;
    return {range_gate(in, which),
            regimes_gate(in, which),
            scaling_gate(in, which),
            placebo_gate(in, which),
            refinement_gate(in, which),
            {"own_mismatch", clean ? GateResult::passed : GateResult::failed,
             fmt::format("The extended model {} its own test of mismatch (p = {:.3g}).",
                         clean ? "passes" : "fails", in.own_p_value)}};
}

bool serves_all(const GateInput& in) {
    for (std::size_t k = 0; k < in.winner.h.terms.size(); ++k)
        if (regimes_gate(in, k).result == GateResult::failed ||
            scaling_gate(in, k).result == GateResult::failed)
            return false;
    return true;
}

bool passes(const std::vector<Gate>& list) {
    return std::all_of(list.begin(), list.end(), [](const Gate& g) {
        const bool must = g.name == "range" || g.name == "own_mismatch";
        return g.result == GateResult::passed || (g.result == GateResult::untestable && !must);
    });
}

}  // namespace diagnose
