// SPDX-License-Identifier: MIT
#include "diagnose/next_experiment.hpp"

#include "diagnose/piles.hpp"
#include "diagnose/scores.hpp"
#include "diagnose/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace diagnose {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

struct Design {
    std::string rig;
    std::map<std::string, std::string> conditions, grain;
    std::vector<std::string> channels;
    double from = 0.0, to = 1.0;  // of the ordinate
    int rows = 200;
};

cases::Value text_value(const std::string& where, const std::string& text) {
    return {.where = where, .kind = cases::Value::Kind::text, .written_text = text};
}

cases::Value conditions_of(const Design& d) {
    cases::Value v{.where = "next_experiment.conditions"};
    for (const auto& [key, text] : d.conditions)
        v.members.push_back({key, text_value(v.where + "." + key, text)});
    return v;
}

std::string ordinate_of(const std::string& rig) {
    return rig == "impact" ? "angle" : rig == "pull_off" ? "separation" : "t";
}

cases::Recording blank_recording(const Design& d) {
    const std::string ordinate = ordinate_of(d.rig);
    cases::Recording r;
    cases::Column at{.name = ordinate,
                     .unit = ordinate == "t"       ? "s"
                             : ordinate == "angle" ? "rad"
                                                   : "m"};
    cases::Column branch{.name = "branch", .unit = ""};
    const int passes = d.rig == "pull_off" ? 2 : 1;
    for (int pass = 0; pass < passes; ++pass)
        for (int k = 0; k < d.rows / passes; ++k) {
            const double share = static_cast<double>(k) / (d.rows / passes - 1);
            at.values.push_back(d.from + (d.to - d.from) * (pass == 0 ? share : 1.0 - share));
            if (passes == 2) branch.words.push_back(pass == 0 ? "approach" : "retract");
        }
    r.columns.push_back(at);
    if (passes == 2) r.columns.push_back(branch);
    for (const std::string& c : d.channels)
        r.columns.push_back({.name = c,
                             .unit = unit_of_channel(c),
                             .values = std::vector<double>(at.values.size(), 0.0)});
    return r;
}

std::string si(double value, const char* unit) { return fmt::format("{:.6g} {}", value, unit); }

// Designs that a laboratory could set up with this grain and plate.
std::vector<Design> designs(const Problem& p) {
    const cases::Experiment& e = *p.records.front().experiment;
    const double d = e.grain.diameter.value.value(), rho = e.grain.density.value.value();
    const double g = e.surroundings.gravity.value() > 0.0 ? e.surroundings.gravity.value() : 9.81;
    const double weight = rho * 0.5236 * d * d * d * g;
    const bool gravity =
        p.world.physics.contains("gravity") && e.surroundings.gravity.value() > 0.0;
    std::vector<Design> list;
    const auto fall = [&](double h) { return std::sqrt(2.0 * h / g); };
    if (gravity) {
        for (const double h : {0.02, 0.1, 0.5, 3.0})
            for (const double across : {0.0, 1.0}) {
                Design x{"drop", {{"height", si(h, "m")}}, {}, {"z"}, 0.0, 5.0 * fall(h), 200};
                if (across > 0.0)
                    x.conditions["horizontal_speed"] = si(across, "m/s"), x.channels.push_back("x");
                list.push_back(x);
            }
        for (const double degrees : {3.0, 10.0, 25.0})
            for (const double speed : {0.0, 0.5, -0.5})
                list.push_back({"incline",
                                {{"angle", si(degrees, "deg")}, {"speed", si(speed, "m/s")}},
                                {},
                                {"s", "spin"},
                                0.0,
                                0.5,
                                150});
    }
    for (const double speed : {0.3, 1.0, 4.0})
        list.push_back({"impact",
                        {{"speed", si(speed, "m/s")}},
                        {},
                        {"rebound_angle", "normal_restitution", "rebound_spin"},
                        0.05,
                        1.3,
                        26});
    for (const double load : {0.1, 3.0, 100.0})
        for (const double reach : {0.02, 3.0}) {  // diameters: contact and bridges; charges
            const double newtons = std::max(load * weight, 1e-9);
            // Pressed to where a Hertz contact carries the load.
            const double e_star = 0.55 * e.grain.youngs_modulus.value.value();
            const double depth =
                std::pow(0.75 * newtons / (e_star * std::sqrt(0.5 * d)), 2.0 / 3.0);
            list.push_back({"pull_off",
                            {{"counterpart", "plate"}, {"preload", si(newtons, "N")}},
                            {},
                            {"force"},
                            std::max(reach * d, 3.0 * depth),
                            -depth,
                            240});
        }
    return list;
}

// What a careful laboratory has, where the case has no such channel.
double usual_noise(const Design& d, const std::string& channel, const VectorXd& seen) {
    const double range = seen.size() > 0 ? seen.maxCoeff() - seen.minCoeff() : 0.0;
    if (channel == "z" || channel == "x" || channel == "s") return std::max(2e-4, 2e-3 * range);
    if (channel == "force") return std::max(0.002 * range, 1e-12);
    if (channel == "rebound_angle") return 0.004;
    if (d.rig == "impact" && !channel.ends_with("spin")) return 0.005;
    return std::max(0.01 * range, 0.5);
}

struct Tried {
    double sigma = 0.0;
    std::map<std::string, double> noise;
};

Tried tried(const Problem& p, const Noise& noise, const std::vector<const Candidate*>& alike,
            const Design& d) {
    cases::Case with = *p.given;
    std::erase_if(with.experiments, [](const cases::Experiment& e) { return e.held_out; });
    cases::Experiment e = *p.records.front().experiment;
    e.id = "next", e.rig = d.rig, e.conditions = conditions_of(d), e.held_out = false;
    e.recording = blank_recording(d), e.simulated.reset(), e.noise.clear();
    for (const Record& r : p.records)
        for (std::size_t c = 0; c < r.channels.size(); ++c)
            if (r.experiment->rig == d.rig)
                e.noise[r.channels[c].name] =
                    noise[static_cast<std::size_t>(&r - p.records.data())][c].deviation;
    with.experiments.push_back(std::move(e));
    Tried result;
    {
        const Problem alone = problem_of(with, false, p.piles);
        const Candidate shown = carried_over(alone, *alike.front());
        const Record& last = alone.records.back();
        for (const Channel& c : last.channels) {
            double& sd = with.experiments.back().noise[c.name];
            if (sd > 0.0) continue;
            sd = usual_noise(d, c.name,
                             shown.fit.prediction.segment(static_cast<Index>(c.first),
                                                          static_cast<Index>(c.recorded.size())));
        }
    }
    const Problem both = problem_of(with, false, p.piles);
    const Whitener w(both, noise_like(both, p, noise));
    std::vector<Candidate> there;
    for (const Candidate* c : alike) there.push_back(carried_over(both, *c));
    result.sigma = std::numeric_limits<double>::max();
    for (std::size_t k = 0; k < there.size(); ++k)
        for (std::size_t n = k + 1; n < there.size(); ++n)
            result.sigma = std::min(result.sigma, separation(both, w, there[k], there[n]));
    for (const Channel& c : both.records.back().channels) result.noise[c.name] = c.stated_noise;
    return result;
}

}  // namespace

std::optional<NextExperiment> next_experiment(const Problem& p, const Noise& noise,
                                              const std::vector<const Candidate*>& alike,
                                              int threads) {
    const std::vector<Design> list = designs(p);
    std::vector<Tried> outcome(list.size());
    in_parallel(list.size(), threads, [&](std::size_t k) {
        try {
            outcome[k] = tried(p, noise, alike, list[k]);
        } catch (const std::exception&) {
            outcome[k] = {};  // a rig that this model does not run on
        }
    });
    std::size_t best = 0;
    for (std::size_t k = 1; k < outcome.size(); ++k)
        if (outcome[k].sigma > outcome[best].sigma) best = k;
    if (list.empty() || !(outcome[best].sigma > 0.0)) return std::nullopt;
    const Design& d = list[best];
    std::vector<std::string> names, plain;
    for (const Candidate* c : alike)
        names.push_back(c->name()), plain.push_back(plain_name(c->name()));
    return NextExperiment{.rig = d.rig,
                          .conditions = d.conditions,
                          .grain = d.grain,
                          .channels = d.channels,
                          .ordinate = ordinate_of(d.rig),
                          .ordinate_unit = ordinate_of(d.rig) == "t"       ? "s"
                                           : ordinate_of(d.rig) == "angle" ? "rad"
                                                                           : "m",
                          .from = d.from,
                          .to = d.to,
                          .rows = d.rows,
                          .noise = outcome[best].noise,
                          .between = names,
                          .separation_sigma = outcome[best].sigma,
                          .why = fmt::format("Of {} designs it sets these furthest apart: {}.",
                                             list.size(), fmt::join(plain, ", "))};
}

std::unique_ptr<Planned> with_held_out(const Problem& p, const Noise& noise) {
    auto planned = std::make_unique<Planned>(Planned{.with = *p.given, .problem = {}, .noise = {}});
    bool any = false;
    for (cases::Experiment& e : planned->with.experiments) {
        if (!e.held_out) continue;
        if (e.rig == "pile" && (p.piles == nullptr || !p.piles->knows(e))) continue;
        e.recording.reset();
        for (const Record& r : p.records)
            if (r.experiment->rig == e.rig && !e.recording) {
                e.recording = r.experiment->recording;
                for (cases::Column& column : e.recording->columns)
                    if (column.name != r.ordinate && column.name != "azimuth" &&
                        column.words.empty())
                        std::fill(column.values.begin(), column.values.end(), 0.0);
            }
        if (e.recording) {
            e.held_out = false, any = true;
            for (const Record& r : p.records)
                if (r.experiment->rig == e.rig)
                    for (std::size_t c = 0; c < r.channels.size(); ++c)
                        e.noise.try_emplace(
                            r.channels[c].name,
                            noise[static_cast<std::size_t>(&r - p.records.data())][c].deviation);
        }
    }
    if (!any) return nullptr;
    planned->problem = problem_of(planned->with, false, p.piles);
    planned->noise = noise_like(planned->problem, p, noise);
    return planned;
}

}  // namespace diagnose
