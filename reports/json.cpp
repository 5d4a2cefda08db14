// SPDX-License-Identifier: MIT
#include "reports/json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace reports {

namespace {

using scaling::AdhesionPrediction;
using scaling::Cost;
using scaling::Finding;
using scaling::ScaleStudy;

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json factors_json(const ScaleStudy& study) {
    Json factors = Json::object();
    for (const scaling::FactorRow& row : study.factors) {
        Json entry = {{"exponent", scaling::to_string(row.exponents.h)},
                      {"factor", finite(row.factor)}};
        if (!scaling::is_zero(row.exponents.softening))
            entry["softening_exponent"] = scaling::to_string(row.exponents.softening);
        if (row.imposed) entry["imposed"] = true;
        factors[row.quantity] = std::move(entry);
    }
    return factors;
}

Json groups_json(const ScaleStudy& study) {
    Json groups = Json::object();
    for (const scaling::GroupChange& g : study.groups) {
        groups[g.group.name] = {{"formula", g.group.formula},
                                {"original", finite(g.original)},
                                {"scaled", finite(g.scaled)},
                                {"ratio", finite(g.ratio)},
                                {"change", scaling::to_string(g.change)},
                                {"status", g.kept ? "kept" : "broken"}};
    }
    return groups;
}

Json grain_adhesion_json(const scaling::GrainAdhesion& a) {
    return {{"work_of_adhesion", finite(a.work_of_adhesion.value())},
            {"surface_energy", finite(a.surface_energy.value())},
            {"pull_off_force", finite(a.pull_off_force.value())},
            {"pull_off_in_grain_weights", finite(a.pull_off_in_grain_weights)}};
}

Json prediction_json(const AdhesionPrediction& p) {
    return {{"invariant", p.invariant ? Json(scaling::to_string(*p.invariant)) : Json(nullptr)},
            {"exponent", scaling::to_string(p.exponents.h)},
            {"softening_exponent", scaling::to_string(p.exponents.softening)},
            {"original", grain_adhesion_json(p.original)},
            {"scaled", grain_adhesion_json(p.scaled)},
            {"physically_usable", p.physically_usable},
            {"findings", to_json(p.findings)}};
}

Json adhesion_json(const ScaleStudy& study) {
    if (!study.adhesion)
        return {{"invariant", nullptr},
                {"reason", "no work of adhesion is stated for original or scaled grain"}};
    Json adhesion = prediction_json(*study.adhesion);
    if (!study.adhesion->invariant)
        adhesion["reason"] = "the kept quantities settle the adhesion: no invariant is needed";
    Json others = Json::array();
    for (const AdhesionPrediction& p : study.other_invariants) others.push_back(prediction_json(p));
    adhesion["other_invariants"] = std::move(others);
    return adhesion;
}

Json cost_side(const Cost& c) {
    const auto known = [](bool has, double value) { return has ? finite(value) : Json(nullptr); };
    Json side = {
        {"grains", known(c.grains.has_value(), c.grains.value_or(0.0))},
        {"rayleigh_time", finite(c.rayleigh_time.value())},
        {"time_step", finite(c.time_step.value())},
        {"steps", known(c.steps.has_value(), c.steps.value_or(0.0))},
        {"wall_time", known(c.wall_time.has_value(), c.wall_time ? c.wall_time->value() : 0.0)}};
    Json reasons = Json::object();
    if (!c.grains) reasons["grains"] = "neither a count nor a base to pile on is given";
    if (!c.steps) reasons["steps"] = "no simulated time is given";
    if (!c.wall_time) reasons["wall_time"] = "needs grains, steps and a measured speed";
    if (!reasons.empty()) side["reasons"] = std::move(reasons);
    return side;
}

using Angles = std::vector<std::pair<rigs::Estimator, std::optional<rigs::Angle>>>;

Json angles_json(const Angles& list) {
    Json angles = Json::object();
    for (const auto& [estimator, angle] : list) {
        if (angle)
            angles[rigs::to_string(estimator)] = {{"angle", finite(angle->angle)},
                                                  {"spread", finite(angle->spread)},
                                                  {"samples", angle->samples}};
        else
            angles[rigs::to_string(estimator)] = {
                {"angle", nullptr}, {"reason", "fewer than six sectors or views have a flank"}};
    }
    return angles;
}

Json criteria_json(const rigs::Formed& formed) {
    Json criteria = Json::array();
    for (const rigs::Criterion& c : formed.criteria)
        criteria.push_back(
            {{"name", c.name}, {"value", finite(c.value)}, {"rule", c.rule}, {"passed", c.pass}});
    return criteria;
}

Json list_of(const std::vector<double>& values) {
    Json list = Json::array();
    for (const double v : values) list.push_back(finite(v));
    return list;
}

constexpr const char* no_packing = "too few grains lie deep enough inside";

Json heap_json(const rigs::MeasuredHeap& h) {
    Json json = {{"formed", h.formed.formed},
                 {"criteria", criteria_json(h.formed)},
                 {"angle_of_repose", angles_json(h.angles)}};
    json["packing_fraction"] = h.packing ? finite(h.packing->value) : Json(nullptr);
    if (h.packing)
        json["packing_volume"] = finite(h.packing->volume);
    else
        json["packing_fraction_reason"] = no_packing;
    json["profile"] = {{"r", list_of(h.profile.r)},
                       {"z", list_of(h.profile.z)},
                       {"spread", list_of(h.profile.spread)}};
    return json;
}

}  // namespace

Json to_json(const std::vector<Finding>& findings) {
    Json list = Json::array();
    for (const Finding& f : findings) {
        list.push_back({{"name", f.name},
                        {"value", finite(f.value)},
                        {"rule", f.rule},
                        {"judgement", scaling::to_string(f.judgement)},
                        {"text", f.text}});
    }
    return list;
}

Json to_json(const ScaleStudy& study) {
    Json kept = Json::array();
    for (const scaling::Demand& d : study.scheme.demands)
        kept.push_back(d.exponents == scaling::Exponents{}
                           ? d.quantity
                           : d.quantity + " x " + scaling::to_string(d.exponents));
    return {{"units", "SI"},
            {"scheme", study.scheme.name},
            {"kept", std::move(kept)},
            {"distorted", study.distorted},
            {"h", study.h},
            {"softening", study.softening},
            {"exact_in_binary", study.exact_in_binary},
            {"factors", factors_json(study)},
            {"groups", groups_json(study)},
            {"adhesion", adhesion_json(study)},
            {"scale_number",
             {{"original", finite(study.original_scale_number.value)},
              {"scaled", finite(study.scaled_scale_number.value)},
              {"original_class", scaling::to_string(study.original_scale_number.size_class)},
              {"scaled_class", scaling::to_string(study.scaled_scale_number.size_class)}}},
            {"cost",
             {{"original", cost_side(study.original_cost)},
              {"scaled", cost_side(study.scaled_cost)},
              {"originals_per_grain", finite(study.originals_per_grain)}}},
            {"findings", to_json(study.findings)}};
}

Json to_json(const cases::Case& c, const ScaleStudy& study, double grain_steps_per_second,
             const Provenance& who) {
    Json json = {{"format", "similitude-scale/1"},
                 {"case", c.path},
                 {"title", c.title},
                 {"tool", to_json(who)}};
    json.update(to_json(study));
    json["cost"]["grain_steps_per_second"] = grain_steps_per_second;
    return json;
}

Json to_json(const rigs::PileRecord& r) {
    Json json = {{"at_rest", r.at_rest},
                 {"formed", r.formed.formed},
                 {"criteria", criteria_json(r.formed)},
                 {"angle_of_repose", angles_json(r.angles)}};
    json["packing_fraction"] = r.packing_fraction ? finite(*r.packing_fraction) : Json(nullptr);
    if (!r.packing_fraction) json["packing_fraction_reason"] = no_packing;
    json["coordination"] = finite(r.coordination);
    json["grains_fed"] = r.grains_fed;
    json["grains_lost"] = r.grains_lost;
    json["grains_in_funnel"] = r.grains_in_funnel;
    if (r.heap.spheres > 1)
        json["shape"] = {{"aspect_ratio", finite(r.aspect_ratio)},
                         {"spheres_per_grain", r.heap.spheres},
                         {"spheres_in_heap", r.heap.centre.size()}};
    json["slept"] = finite(r.work.share_slept());
    json["slept_while_fed"] = finite(r.work_while_fed.share_slept());
    json["grain_steps"] = {{"asked", r.work.asked}, {"done", r.work.asked - r.work.slept}};
    json["steps"] = r.steps;
    json["time_step"] = finite(r.time_step);
    json["base_radius"] = finite(r.base_radius);
    json["grain_diameter"] = finite(r.grain_diameter);
    json["hash"] = fmt::format("{:016x}", r.hash);
    if (!r.notes.empty()) json["notes"] = r.notes;
    return json;
}

Json to_json(const rigs::Measured& m) {
    return {{"grains",
             {{"heap", m.loose},
              {"fixed", m.fixed},
              {"below_base", m.below_base},
              {"beyond_rim", m.beyond_rim}}},
            {"diameter",
             {{"smallest", finite(m.smallest)},
              {"mean", finite(m.mean)},
              {"largest", finite(m.largest)}}},
            {"coordination", finite(m.contacts.coordination)},
            {"contacts", {{"between_grains", m.contacts.pairs}, {"at_base", m.contacts.at_base}}},
            {"largest_overlap_over_r_star", finite(m.contacts.largest_overlap)},
            {"heap", m.heap ? heap_json(*m.heap) : Json(nullptr)}};
}

Json to_json(const rigs::DropRecord& r) {
    return {{"settled", r.settled},
            {"settled_at", r.settled ? finite(r.settled_at) : Json(nullptr)},
            {"impacts", r.impacts},
            {"steps", r.steps}};
}

Json to_json(const rigs::FlowRecord& r) {
    Json quantities = Json::object();
    for (const rigs::FlowQuantity& q : r.quantities)
        quantities[q.name] = {{"value", finite(q.value)}, {"unit", q.unit}};
    return {{"ending", r.ending},
            {"quantities", std::move(quantities)},
            {"steps", r.steps},
            {"hash", fmt::format("{:016x}", r.hash)}};
}

Json to_json(const Provenance& p) {
    Json json = {{"name", "similitude"},
                 {"version", p.version},
                 {"git", p.git},
                 {"compiler", p.compiler},
                 {"command", p.command}};
    if (!p.case_path.empty()) json["case"] = p.case_path;
    if (!p.seeds.empty()) json["seeds"] = p.seeds;
    if (p.threads) json["threads"] = *p.threads;
    return json;
}

std::string text_of(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace reports
