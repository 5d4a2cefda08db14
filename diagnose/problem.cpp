// SPDX-License-Identifier: MIT
#include "diagnose/problem.hpp"

#include "cases/effects.hpp"
#include "cases/rig_table.hpp"
#include "diagnose/own_run.hpp"
#include "diagnose/piles.hpp"
#include "rigs/effects.hpp"
#include "scaling/errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace diagnose {
namespace {

std::string ordinate_of(const cases::Experiment& e) {
    if (e.rig == "impact") return "angle";
    if (e.rig == "pull_off")
        return e.recording->has("displacement") ? "displacement" : "separation";
    return "t";
}

Record record_of(const cases::Experiment& e, const Piles* piles, std::size_t& size) {
    if (e.rig == "pile" && piles != nullptr) {
        Record record = piles->record(e);
        for (Channel& c : record.channels) c.first = size, size += c.recorded.size();
        return record;
    }
    Record record{.experiment = &e,
                  .model = rigs::forward_model(e),
                  .ordinates = rigs::recorded_ordinates(e),
                  .ordinate = ordinate_of(e),
                  .channels = {}};
    for (const cases::Column& column : e.recording->columns) {
        if (column.name == record.ordinate || !column.words.empty()) continue;
        if (e.rig == "pull_off" && column.name != "force") continue;
        Channel channel{.name = column.name, .recorded = column.values};
        const auto noise = e.noise.find(column.name);
        if (noise != e.noise.end()) channel.stated_noise = noise->second;
        channel.first = size;
        size += channel.recorded.size();
        record.channels.push_back(std::move(channel));
    }
    return record;
}

Unknown nuisance(const std::string& key, const std::string& unit, double value, double deviation,
                 double low, const std::string& experiment) {
    return {.name = key + (experiment.empty() ? "" : "@" + experiment),
            .unit = unit,
            .target = Target::stated,
            .key = key,
            .prior = Prior::gaussian,
            .low = std::max(low, value - 8.0 * deviation),
            .high = value + 8.0 * deviation,
            .mean = value,
            .deviation = deviation,
            .experiment = experiment,
            .start = value};
}

template <class Q>
void add_if_uncertain(std::vector<Unknown>& list, const std::string& key, const std::string& unit,
                      const cases::Measured<Q>& m, const std::string& experiment) {
    if (m.uncertainty.value() > 0.0)
        list.push_back(nuisance(key, unit, m.value.value(), m.uncertainty.value(),
                                1e-6 * m.value.value(), experiment));
}

bool same(const cases::Grain& a, const cases::Grain& b) {
    return a.diameter.value == b.diameter.value && a.density.value == b.density.value &&
           a.youngs_modulus.value == b.youngs_modulus.value &&
           a.poisson_ratio.value == b.poisson_ratio.value;
}

void add_grain(std::vector<Unknown>& list, const cases::Grain& g, const std::string& experiment) {
    add_if_uncertain(list, "grain.diameter", "m", g.diameter, experiment);
    add_if_uncertain(list, "grain.density", "kg/m^3", g.density, experiment);
    add_if_uncertain(list, "grain.youngs_modulus", "Pa", g.youngs_modulus, experiment);
    add_if_uncertain(list, "grain.poisson_ratio", "1", g.poisson_ratio, experiment);
}

// Grains that the experiments share are one unknown, others one each.
void add_nuisances(Problem& p) {
    bool shared_done = false;
    for (const Record& r : p.records) {
        const cases::Experiment& e = *r.experiment;
        if (!same(e.grain, p.given->grain))
            add_grain(p.base, e.grain, e.id);
        else if (!shared_done)
            add_grain(p.base, e.grain, ""), shared_done = true;
        for (const cases::Condition& rule : cases::rig_rule(e.rig).conditions) {
            if (rule.unit.empty() || !e.conditions.has(rule.name)) continue;
            const cases::Value& v = e.conditions.at(rule.name);
            if (v.kind == cases::Value::Kind::text && !v.has("uncertainty") &&
                std::find(rule.words.begin(), rule.words.end(), v.written_text) != rule.words.end())
                continue;
            const double deviation = v.si_uncertainty(cases::parse_unit(rule.unit, rule.name));
            if (deviation > 0.0)
                p.base.push_back(nuisance("conditions." + rule.name, rule.unit,
                                          v.si(cases::parse_unit(rule.unit, rule.name)), deviation,
                                          -std::numeric_limits<double>::infinity(), e.id));
        }
    }
}

// Offset and slope of the base line of a force curve over the drive: of the force's range, centred on nothing.
void add_base_lines(Problem& p) {
    for (const Record& r : p.records) {
        if (r.ordinate != "displacement") continue;
        const std::vector<double>& f = r.channels.front().recorded;
        double low = 1e300, high = -1e300, left = 1e300, right = -1e300;
        for (const double v : f)
            if (std::isfinite(v)) low = std::min(low, v), high = std::max(high, v);
        for (const double x : r.ordinates.at) left = std::min(left, x), right = std::max(right, x);
        const double range = high - low, width = std::max(right - left, 1e-300);
        if (!(range > 0.0)) continue;
        const auto line = [&](Target target, const char* name, const char* unit, double deviation) {
            return Unknown{.name = std::string(name) + "@" + r.experiment->id,
                           .unit = unit,
                           .target = target,
                           .key = "force",
                           .prior = Prior::gaussian,
                           .low = -10.0 * deviation,
                           .high = 10.0 * deviation,
                           .mean = 0.0,
                           .deviation = deviation,
                           .experiment = r.experiment->id};
        };
        p.base.push_back(line(Target::base_line, "base_line_offset", "N", 0.5 * range));
        p.base.push_back(
            line(Target::base_line_slope, "base_line_slope", "N/m", 0.2 * range / width));
    }
}

// A parameter that no physics of the case uses is not fitted.
bool used(const Problem& p, const std::string& name) {
    const std::set<std::string>& physics = p.world.physics;
    const auto rig = [&](const char* n) {
        return std::any_of(p.records.begin(), p.records.end(),
                           [&](const Record& r) { return r.experiment->rig == n; });
    };
    if (name == "restitution")
        return !physics.contains("viscoelastic_restitution") &&
               (rig("drop") || rig("impact") || rig("pile"));
    if (name.ends_with("rolling_friction") && !physics.contains("rolling_resistance")) return false;
    if (name == "work_of_adhesion") return physics.contains("adhesion");
    if (name == "wall_work_of_adhesion") return physics.contains("wall_adhesion") && rig("pile");
    return !name.starts_with("wall_") || rig("pile");
}

void add_free_parameters(Problem& p) {
    for (const auto& [name, parameter] : p.given->model.parameters) {
        if (!parameter.range || !used(p, name)) continue;
        p.base.push_back({.name = name,
                          .unit = parameter.unit,
                          .key = name == "drag_coefficient" ? "drag_factor" : name,
                          .prior = Prior::uniform,
                          .low = parameter.range->first,
                          .high = parameter.range->second,
                          .start = parameter.value});
    }
}

}  // namespace

std::string unit_of_channel(const std::string& name) {
    if (name.starts_with("z") || name == "x" || name == "s") return "m";
    if (name == "force") return "N";
    if (name == "rebound_angle") return "rad";
    return name.ends_with("spin") ? "rad/s" : "1";
}

std::string Hypothesised::name() const {
    std::string text;
    for (const Term* t : terms) text += (text.empty() ? "" : " + ") + t->effect;
    return text.empty() ? "none" : text;
}

Hypothesised Problem::hypothesis(std::vector<const Term*> terms) const {
    Hypothesised h{.terms = std::move(terms), .unknowns = {}};
    for (const Unknown& u : base) {
        const bool idle = std::any_of(h.terms.begin(), h.terms.end(), [&](const Term* t) {
            return std::find(t->idle.begin(), t->idle.end(), u.key) != t->idle.end();
        });
        if (!idle) h.unknowns.push_back(u);
    }
    for (const Term* t : h.terms)
        h.unknowns.insert(h.unknowns.end(), t->unknowns.begin(), t->unknowns.end());
    return h;
}

bool is_lone_angle(const cases::Experiment& e) {
    return e.rig == "pile" && e.recording && !e.recording->has("r");
}

Problem problem_of(const cases::Case& c, bool held_out, const Piles* piles) {
    Problem p;
    p.piles = piles;
    p.given = &c;
    for (const cases::Experiment& e : c.experiments)
        if (e.held_out == held_out && e.recording && !is_lone_angle(e))
            p.records.push_back(record_of(e, piles, p.size));
    if (p.records.empty()) return p;
    p.world = rigs::world_of(c, *p.records.front().experiment);
    add_free_parameters(p);
    add_nuisances(p);
    add_base_lines(p);
    p.recorded.resize(static_cast<Eigen::Index>(p.size));
    for (const Record& r : p.records)
        for (const Channel& channel : r.channels)
            for (std::size_t k = 0; k < channel.recorded.size(); ++k)
                p.recorded[static_cast<Eigen::Index>(channel.first + k)] = channel.recorded[k];
    compare_own_runs(p);
    return p;
}

std::vector<double> missing_at(const Hypothesised& h, const Eigen::VectorXd& theta, const Term& t) {
    std::vector<double> values(t.missing_knots.size(), 0.0);
    for (std::size_t k = 0; k < h.unknowns.size(); ++k) {
        if (h.unknowns[k].target != Target::missing_shape) continue;
        const std::vector<double>& shape = t.missing_shapes[h.unknowns[k].index];
        for (std::size_t j = 0; j < values.size(); ++j)
            values[j] += theta[static_cast<Eigen::Index>(k)] * shape[j];
    }
    return values;
}

rigs::World world_at(const Problem& p, const Hypothesised& h, const Eigen::VectorXd& theta,
                     const Record& record) {
    rigs::World world = p.world;
    // Whatever is added is run resolved: physics is not to make up for a coarse step.
    if (!h.terms.empty()) world.numerics.reset();
    for (const Term* t : h.terms) {
        if (t->effect == "numerical_artefact") continue;
        if (t->effect == "tangential_compliance")
            world.physics.erase("hertz_coulomb"),
                world.physics.insert({"hertz_mindlin", t->effect});
        else if (!t->missing_variable.empty() && t->missing_rigs.contains(record.experiment->rig)) {
            if (t->missing == Missing::restitution)
                world.missing_restitution = rigs::MissingRestitution{
                    t->missing_variable, t->missing_knots, missing_at(h, theta, *t)};
            if (t->missing == Missing::force)
                world.missing = rigs::MissingForce{t->missing_variable, t->missing_knots,
                                                   missing_at(h, theta, *t)};
        } else if (t->missing_variable.empty() && t->channel.empty() && t->effect != "time_base")
            world.physics.insert(t->effect);
    }
    for (std::size_t k = 0; k < h.unknowns.size(); ++k) {
        const Unknown& u = h.unknowns[k];
        const double value = theta[static_cast<Eigen::Index>(k)];
        if (!u.experiment.empty() && u.experiment != record.experiment->id) continue;
        if (u.target == Target::parameter) world.parameters[u.key] = value;
        if (u.target == Target::stated) world.stated[u.key] = value;
    }
    return world;
}

namespace {

struct Instrument {
    double time_factor = 1.0;
    std::map<std::string, double> scale, offset;
    double base_line = 0.0, slope = 0.0;
    const Term* drift = nullptr;
    std::vector<double> drift_knots{};  // values
};

Instrument instrument_at(const Hypothesised& h, const Eigen::VectorXd& theta,
                         const Record& record) {
    Instrument i;
    for (const Term* t : h.terms)
        if (t->missing == Missing::drift && t->missing_rigs.contains(record.experiment->rig))
            i.drift = t, i.drift_knots = missing_at(h, theta, *t);
    for (std::size_t k = 0; k < h.unknowns.size(); ++k) {
        const Unknown& u = h.unknowns[k];
        const double value = theta[static_cast<Eigen::Index>(k)];
        if (!u.experiment.empty() && u.experiment != record.experiment->id) continue;
        if (u.target == Target::time_factor) i.time_factor = value;
        if (u.target == Target::base_line) i.base_line = value;
        if (u.target == Target::base_line_slope) i.slope = value;
        if (u.target == Target::offset) i.offset[u.key] = value;
        if (u.target != Target::scale) continue;
        for (const Channel& c : record.channels)
            if (("," + u.key + ",").find("," + c.name + ",") != std::string::npos)
                i.scale[c.name] = value;
    }
    return i;
}

}  // namespace

Eigen::VectorXd predicted(const Problem& p, const Hypothesised& h, const Eigen::VectorXd& theta,
                          int only, const std::vector<std::size_t>& rows) {
    Eigen::VectorXd y = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(p.size));
    for (std::size_t j = 0; j < p.records.size(); ++j) {
        if (only >= 0 && static_cast<std::size_t>(only) != j) continue;
        const Record& r = p.records[j];
        if (!rows.empty() && rows[j] == 0) continue;
        const Instrument i = instrument_at(h, theta, r);
        const bool shortened =
            !rows.empty() && r.ordinate == "t" && rows[j] < r.ordinates.at.size();
        rigs::Curves curves;
        if (i.time_factor == 1.0 && !shortened) {
            curves = r.model->predict(world_at(p, h, theta, r), r.ordinates);
        } else {
            rigs::Ordinates at = r.ordinates;
            if (shortened) at.at.resize(rows[j]);
            for (double& t : at.at) t /= i.time_factor;
            curves = r.model->predict(world_at(p, h, theta, r), at);
        }
        double middle = 0.0;
        if (i.slope != 0.0) {
            for (const double x : r.ordinates.at) middle += x;
            middle /= static_cast<double>(r.ordinates.at.size());
        }
        for (const Channel& c : r.channels) {
            const auto found = curves.find(c.name);
            if (found == curves.end()) continue;
            const auto scale = i.scale.find(c.name), offset = i.offset.find(c.name);
            for (std::size_t k = 0; k < found->second.size(); ++k) {
                double v = found->second[k];
                if (!std::isfinite(v)) continue;
                if (scale != i.scale.end()) v *= scale->second;
                if (offset != i.offset.end()) v += offset->second;
                if (i.drift && i.drift->channel == c.name)
                    v += rigs::straight_between(i.drift->missing_knots, i.drift_knots,
                                                r.ordinates.at[k]);
                if (h.terms.empty() && !c.own_run_off.empty()) v += c.own_run_off[k];
                if (r.ordinate == "displacement")
                    v += i.base_line + i.slope * (r.ordinates.at[k] - middle);
                y[static_cast<Eigen::Index>(c.first + k)] = v;
            }
        }
    }
    return y;
}

Eigen::VectorXd rows_of(const Problem& p, std::size_t record, const Eigen::VectorXd& v) {
    Eigen::VectorXd part = Eigen::VectorXd::Zero(v.size());
    for (const Channel& c : p.records[record].channels)
        part.segment(static_cast<Eigen::Index>(c.first),
                     static_cast<Eigen::Index>(c.recorded.size())) =
            v.segment(static_cast<Eigen::Index>(c.first),
                      static_cast<Eigen::Index>(c.recorded.size()));
    return part;
}

}  // namespace diagnose
