// SPDX-License-Identifier: MIT
#include "calibrate/pile_problem.hpp"

#include "cases/effects.hpp"
#include "cases/messages.hpp"
#include "scaling/errors.hpp"
#include "statistics/intervals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace calibrate {
namespace {

using rigs::Estimator;
using scaling::InvalidInput;
using scaling::mistake;

constexpr double degree = std::numbers::pi / 180.0;
constexpr double density_trusted_to = 0.05;
constexpr double decade = 10.0;
// Of d: a cone of 20 deg on it has ten cubes of d in the inside that rigs::packing_fraction reads.
constexpr double base_with_an_inside = 20.0;

std::vector<Factor> free_parameters(const cases::Case& c) {
    std::vector<Factor> factors;
    for (const auto& [name, parameter] : c.model.parameters) {
        if (!parameter.range) continue;
        const auto [low, high] = *parameter.range;
        factors.push_back({name, parameter.unit, low, high, low > 0.0 && high >= decade * low});
    }
    if (factors.empty())
        throw InvalidInput(mistake(c.path + ": model.parameters", "none with a range",
                                   "must hold one to calibrate",
                                   "write {\"value\": 0.5, \"range\": [0.2, 0.8]}"));
    return factors;
}

std::string estimator_of_row(const cases::Experiment& e, std::size_t row) {
    return e.recording->has("estimator") ? e.recording->column("estimator").words.at(row)
                                         : e.conditions.at("estimator").text();
}

// The recorded angles by one estimator; `name` is filled in where it is empty.
std::vector<double> recorded_angles(const cases::Case& c, const cases::Experiment& e,
                                    std::string& name) {
    const std::string where = c.path + ": experiments " + cases::in_quotes(e.id) + ".recording";
    if (!e.recording || !e.recording->has("angle_of_repose"))
        throw InvalidInput(
            mistake(where, e.recording ? "neither angle nor profile" : "nothing",
                    "must hold angle_of_repose, or azimuth, r and z, to calibrate against",
                    "photo and measure read it off pictures and grains"));
    const std::vector<double>& all = e.recording->values("angle_of_repose");
    std::vector<double> angles;
    std::vector<std::string> known;
    for (std::size_t k = 0; k < all.size(); ++k) {
        const std::string by = estimator_of_row(e, k);
        if (std::find(known.begin(), known.end(), by) == known.end()) known.push_back(by);
        if (name.empty()) name = by;
        if (by == name && std::isfinite(all[k])) angles.push_back(all[k] / degree);
    }
    if (angles.empty())
        throw InvalidInput(mistake("--estimator", cases::in_quotes(name),
                                   "must be one that the recording has",
                                   cases::suggestion(name, known)));
    return angles;
}

double deviation_of_mean(const cases::Case& c, const cases::Experiment& e,
                         const std::vector<double>& angles) {
    double one = 0.0;
    if (const auto noise = e.noise.find("angle_of_repose"); noise != e.noise.end())
        one = noise->second / degree;
    if (angles.size() > 1) one = std::max(one, statistics::summary(angles).standard_deviation);
    if (!(one > 0.0))
        throw InvalidInput(
            mistake(c.path + ": experiments " + cases::in_quotes(e.id) + ".noise",
                    "no deviation of the angle of repose", "must be > 0",
                    "record several heaps, or state \"noise\": {\"angle_of_repose\": \"2 deg\"}"));
    return one / std::sqrt(static_cast<double>(angles.size()));
}

// Where it is not asked for, it tells what such a measurement would fix.
Target bulk_density(const cases::Case& c, bool asked) {
    const double stated = c.stated.bulk_density->value();
    return {"bulk_density", "kg/m^3", asked ? std::optional(stated) : std::nullopt,
            density_trusted_to * stated};
}

void take_angle(PileProblem& p, const cases::Case& c, const cases::Experiment& e,
                std::string name) {
    p.angles = recorded_angles(c, e, name);
    p.estimator = rigs::estimator_named(name);
    if (p.estimator == Estimator::protractor) {
        p.estimator = Estimator::silhouette;
        p.notes.emplace_back(
            "recorded by protractor on a picture; simulated heaps are read by their silhouette");
    }
    double mean = 0.0;
    for (const double angle : p.angles) mean += angle / static_cast<double>(p.angles.size());
    p.problem.targets = {{"angle_of_repose", "deg", mean, deviation_of_mean(c, e, p.angles)}};
}

std::optional<double> angle_of(const HeapSeen& heap, Estimator estimator) {
    const auto& all = rigs::computed_estimators;
    const auto at = std::find(all.begin(), all.end(), estimator) - all.begin();
    return heap.angles[static_cast<std::size_t>(at)];
}

}  // namespace

PileProblem pile_problem(const cases::Case& c, const cases::Experiment& e, const PileOptions& o,
                         std::uint64_t seed) {
    PileProblem p{};
    p.experiment = e.id;
    p.problem.seed = seed;
    p.problem.factors = free_parameters(c);
    p.rings = ring_heights(c, e);
    if (p.rings.empty() || e.recording->has("angle_of_repose")) take_angle(p, c, e, o.estimator);
    for (const RingHeight& ring : p.rings) p.problem.targets.push_back(ring.target);
    if (p.problem.targets.size() > 1)
        p.notes.emplace_back(
            "angle and heights of one heap count as independent of one another: intervals are "
            "narrower than the recording warrants");
    if (o.bulk_density && !c.stated.bulk_density)
        throw InvalidInput(mistake(c.path + ": stated.bulk_density", "nothing",
                                   "must be given to calibrate against it",
                                   "write \"2.05 g/cm^3\", or leave --bulk-density out"));
    const double base = e.conditions.at("base_diameter").quantity<scaling::Length>().value();
    const bool wide = base >= base_with_an_inside * e.grain.diameter.value.value();
    if (c.stated.bulk_density && (o.bulk_density || wide))
        p.problem.targets.push_back(bulk_density(c, o.bulk_density));
    if (o.bulk_density)
        p.notes.emplace_back(
            "the stated bulk density is trusted to 5 % and held against the inside of the heap");
    return p;
}

cases::Case at_point(const cases::Case& c, const Problem& p, const Eigen::VectorXd& point) {
    cases::Case there = c;
    for (std::size_t k = 0; k < p.factors.size(); ++k) {
        cases::Parameter& parameter = there.model.parameters.at(p.factors[k].name);
        parameter.value = point[static_cast<Eigen::Index>(k)];
        parameter.range.reset();
    }
    return there;
}

Eigen::VectorXd stated_point(const cases::Case& c, const Problem& p,
                             const std::vector<std::string>& instead) {
    Eigen::VectorXd point(static_cast<Eigen::Index>(p.factors.size()));
    std::vector<std::string> names;
    for (const Factor& f : p.factors) {
        point[static_cast<Eigen::Index>(names.size())] = c.model.parameters.at(f.name).value;
        names.push_back(f.name);
    }
    for (const std::string& text : instead) {
        const std::size_t equals = text.find('=');
        const std::string name = text.substr(0, equals);
        const auto found = std::find(names.begin(), names.end(), name);
        if (equals == std::string::npos || found == names.end())
            throw InvalidInput(mistake("--at", cases::in_quotes(text),
                                       "must be NAME=VALUE of a parameter with a range",
                                       cases::suggestion(name, names)));
        const Factor& f = p.factors[static_cast<std::size_t>(found - names.begin())];
        const cases::Value value{.where = "--at " + name,
                                 .kind = cases::Value::Kind::text,
                                 .written_text = text.substr(equals + 1)};
        const auto rule =
            std::find_if(cases::parameter_rules().begin(), cases::parameter_rules().end(),
                         [&](const auto& r) { return r.name == name; });
        point[found - names.begin()] = cases::checked(value, f.unit, rule->domain);
    }
    return point;
}

std::optional<std::vector<double>> values_of(const PileProblem& p, const HeapSeen& heap,
                                             double density) {
    if (!heap.formed || !heap.at_rest) return std::nullopt;
    std::vector<std::optional<double>> seen;
    if (p.estimator) seen.push_back(angle_of(heap, *p.estimator));
    for (const RingHeight& ring : p.rings)
        seen.push_back(height_in(ring, heap.profile_r, heap.profile_z));
    if (p.problem.targets.size() > seen.size())
        seen.push_back(heap.packing_fraction ? std::optional(*heap.packing_fraction * density)
                                             : std::nullopt);
    std::vector<double> values;
    for (const std::optional<double>& value : seen) {
        if (!value) return std::nullopt;
        values.push_back(*value);
    }
    return values;
}

}  // namespace calibrate
