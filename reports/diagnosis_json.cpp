// SPDX-License-Identifier: MIT
#include "reports/diagnosis_json.hpp"

#include "cases/rig_table.hpp"
#include "cases/units.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

namespace reports {

namespace {

constexpr double grid = 1e6;  // probabilities have six decimals

Json at_place(double probability) {
    if (!std::isfinite(probability)) return nullptr;
    return std::round(std::clamp(probability, 0.0, 1.0) * grid) / grid;
}

// Shares of a whole in millionths, by largest remainder, so that their sum is one as printed.
std::vector<std::int64_t> millionths(const std::vector<double>& shares) {
    const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
    std::vector<std::int64_t> whole(shares.size(), 0);
    if (!(sum > 0.0) || !std::isfinite(sum)) return whole;
    std::vector<std::pair<double, std::size_t>> rest;
    auto missing = static_cast<std::int64_t>(grid);
    for (std::size_t k = 0; k < shares.size(); ++k) {
        const double exact = shares[k] / sum * grid;
        whole[k] = static_cast<std::int64_t>(exact);
        missing -= whole[k];
        rest.emplace_back(static_cast<double>(whole[k]) - exact, k);
    }
    std::stable_sort(rest.begin(), rest.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t k = 0; k < rest.size() && missing > 0; ++k, --missing) ++whole[rest[k].second];
    return whole;
}

void give_reason(Json& object, const std::string& key, const std::string& reason) {
    object["reasons"][key] = reason;
}

void put(Json& object, const std::string& key, double value, const char* reason) {
    object[key] = std::isfinite(value) ? Json(value) : Json(nullptr);
    if (!std::isfinite(value)) give_reason(object, key, reason);
}

void put(Json& object, const std::string& key, double value, const std::string& unit,
         const char* reason) {
    object[key] = std::isfinite(value) ? Json(cases::format_si(value, unit)) : Json(nullptr);
    if (!std::isfinite(value)) give_reason(object, key, reason);
}

Json finite_list(const std::vector<double>& values) {
    Json list = Json::array();
    for (const double v : values) list.push_back(std::isfinite(v) ? Json(v) : Json(nullptr));
    return list;
}

Json located_json(const diagnose::Located& l) {
    constexpr const char* open = "the recordings do not bound it";
    Json json = {{"experiment", l.experiment}, {"channel", l.channel}, {"variable", l.variable}};
    put(json, "from", l.from, l.unit, open);
    put(json, "to", l.to, l.unit, open);
    json["sign"] = l.sign < 0 ? "-" : "+";
    put(json, "size", l.size, l.size_unit, "it could not be computed");
    put(json, "p_value", l.p_value, "no test was made");
    if (json.contains("reasons")) {  // last
        Json reasons = json["reasons"];
        json.erase("reasons");
        json["reasons"] = std::move(reasons);
    }
    return json;
}

Json estimate_json(const diagnose::Estimate& e) {
    Json json = Json::object();
    json["value"] = std::isfinite(e.value) ? Json(e.value) : Json(nullptr);
    json["ci90"] = finite_list({e.low, e.high});
    json["unit"] = e.unit;
    if (!std::isfinite(e.value)) give_reason(json, "value", "the fit does not bound it");
    if (!std::isfinite(e.low) || !std::isfinite(e.high))
        give_reason(json, "ci90", "the recordings do not bound it");
    return json;
}

Json estimates_json(const std::vector<diagnose::Estimate>& estimates) {
    Json json = Json::object();
    for (const diagnose::Estimate& e : estimates) json[e.name] = estimate_json(e);
    return json;
}

// A function of the state: value and ci90 are lists, one entry for each of `at`.
Json missing_json(const diagnose::MissingEstimate& m) {
    Json bands = Json::array();
    for (std::size_t k = 0; k < std::min(m.low.size(), m.high.size()); ++k)
        bands.push_back(finite_list({m.low[k], m.high[k]}));
    Json json = {{"variable", m.variable},   {"at", finite_list(m.knots)},
                 {"at_unit", m.unit},        {"value", finite_list(m.values)},
                 {"ci90", std::move(bands)}, {"unit", m.unit_of_values},
                 {"words", m.words}};
    if (!m.channel.empty()) json["channel"] = m.channel;
    return json;
}

Json effect_json(const diagnose::Effect& e) {
    Json gates = Json::object(), why = Json::object();
    for (const diagnose::Gate& g : e.gates) {
        gates[g.name] = diagnose::to_string(g.result);
        why[g.name] = g.why;
    }
    Json parameters = estimates_json(e.parameters);
    if (e.missing) parameters[e.missing->what()] = missing_json(*e.missing);
    Json json = {{"name", e.name}, {"probability", at_place(e.probability)}, {"named", e.named}};
    json["parameters"] = std::move(parameters);
    json["gates"] = std::move(gates);
    json["why"] = e.why;
    json["gates_why"] = std::move(why);
    if (json["probability"].is_null()) give_reason(json, "probability", "it could not be computed");
    return json;
}

Json hypotheses_json(const std::vector<diagnose::Hypothesis>& hypotheses) {
    std::vector<double> shares;
    for (const diagnose::Hypothesis& h : hypotheses)
        shares.push_back(std::isfinite(h.probability) ? std::max(0.0, h.probability) : 0.0);
    const std::vector<std::int64_t> whole = millionths(shares);
    Json list = Json::array();
    for (std::size_t k = 0; k < hypotheses.size(); ++k)
        list.push_back({{"effects", hypotheses[k].effects},
                        {"probability", static_cast<double>(whole[k]) / grid}});
    return list;
}

Json scores_json(const diagnose::Scores& s) {
    constexpr const char* none = "a recorded channel is constant or empty";
    Json json = Json::object();
    put(json, "nrmse_base", s.nrmse_base, none);
    put(json, "nrmse_extended", s.nrmse_extended, none);
    put(json, "noise_floor", s.noise_floor, none);
    if (!s.experiments.empty()) json["experiments"] = s.experiments;
    return json;
}

// SI unit of a channel; empty for a rig or channel that is not known.
std::string unit_of(const std::string& rig, const std::string& channel) {
    const std::vector<std::string> rigs = cases::rig_names();
    if (std::find(rigs.begin(), rigs.end(), rig) == rigs.end()) return "";
    const cases::ChannelRule* rule = cases::find_channel(cases::rig_rule(rig), channel);
    return rule == nullptr || rule->units.empty() ? "" : rule->units.front();
}

Json next_json(const diagnose::NextExperiment& n) {
    constexpr const char* open = "the plan leaves it open";
    Json ordinate = {{"name", n.ordinate}};
    put(ordinate, "from", n.from, n.ordinate_unit, open);
    put(ordinate, "to", n.to, n.ordinate_unit, open);
    ordinate["rows"] = n.rows;
    Json noise = Json::object();
    for (const auto& [channel, sigma] : n.noise)
        put(noise, channel, sigma, unit_of(n.rig, channel), "it is not known");
    Json json = {{"rig", n.rig}, {"conditions", n.conditions}};
    if (!n.grain.empty()) json["grain"] = n.grain;
    json["channels"] = n.channels;
    json["ordinate"] = std::move(ordinate);
    json["noise"] = std::move(noise);
    json["between"] = n.between;
    json["separation_sigma"] =
        std::isfinite(n.separation_sigma) ? Json(n.separation_sigma) : Json(nullptr);
    json["why"] = n.why;
    if (!std::isfinite(n.separation_sigma))
        give_reason(json, "separation_sigma", "it could not be computed");
    return json;
}

void put_scores(Json& json, Json& reasons, const char* key,
                const std::optional<diagnose::Scores>& scores, const char* reason) {
    json[key] = scores ? scores_json(*scores) : Json(nullptr);
    if (!scores) reasons[key] = reason;
}

}  // namespace

Json to_json(const diagnose::Verdict& v, const Provenance& who) {
    Json located = Json::array(), effects = Json::array(), reasons = Json::object();
    for (const diagnose::Located& l : v.located) located.push_back(located_json(l));
    for (const diagnose::Effect& e : v.effects) effects.push_back(effect_json(e));
    Json json = {{"format", "similitude-verdict/1"},
                 {"case", who.case_path},
                 {"tool",
                  {{"version", who.version},
                   {"git", who.git},
                   {"seed", v.seed},
                   {"compiler", who.compiler},
                   {"command", who.command}}},
                 {"verdict", diagnose::to_string(v.answer)},
                 {"located", std::move(located)},
                 {"hypotheses", hypotheses_json(v.hypotheses)},
                 {"effects", std::move(effects)}};
    put_scores(json, reasons, "fit", v.fit, "nothing was fitted");
    put_scores(json, reasons, "held_out", v.held_out,
               "none was held out, or the verdict came before any prediction");
    json["refitted"] = estimates_json(v.refitted);
    json["next_experiment"] = v.next_experiment ? next_json(*v.next_experiment) : Json(nullptr);
    json["warnings"] = v.warnings;
    json["title"] = v.title;
    json["p_value"] = std::isfinite(v.p_value) ? Json(v.p_value) : Json(nullptr);
    if (!std::isfinite(v.p_value)) reasons["p_value"] = "no test was made";
    json["summary"] = v.summary;
    json["would_change"] = v.flips;
    json["noise_correlation"] =
        std::isfinite(v.noise_correlation) ? Json(v.noise_correlation) : Json(nullptr);
    if (!std::isfinite(v.noise_correlation))
        reasons["noise_correlation"] = "too few rows to estimate it";
    if (!reasons.empty()) json["reasons"] = std::move(reasons);
    return json;
}

}  // namespace reports
