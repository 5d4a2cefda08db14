// SPDX-License-Identifier: MIT
#include "reports/calibration.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace reports {

namespace {

using namespace calibrate;

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json digit_json(const Recomputed& d) {
    return {{"table", d.table},
            {"what", d.what},
            {"printed", d.printed.text},
            {"recomputed", finite(d.value)},
            {"agrees", d.agrees}};
}

Json means_json(const std::vector<LevelMeans>& means) {
    Json list = Json::array();
    for (const LevelMeans& m : means)
        list.push_back({{"factor", m.factor},
                        {"sum_high", m.sum_high},
                        {"count_high", m.count_high},
                        {"mean_high", finite(m.mean_high)},
                        {"sum_low", m.sum_low},
                        {"count_low", m.count_low},
                        {"mean_low", finite(m.mean_low)},
                        {"effect", finite(m.effect)},
                        {"rank", m.rank}});
    return list;
}

Json row_json(const VarianceRow& r) {
    return {{"source", r.source},
            {"sum_of_squares", finite(r.sum_of_squares)},
            {"degrees_of_freedom", r.degrees_of_freedom},
            {"mean_square", finite(r.mean_square)},
            {"f", finite(r.f)},
            {"p_value", finite(r.p)}};
}

Json variance_json(const AnalysisOfVariance& a) {
    Json rows = Json::array();
    for (const VarianceRow& r : a.factors) rows.push_back(row_json(r));
    return {{"factors", rows},
            {"residual", row_json(a.residual)},
            {"total", row_json(a.total)},
            {"spread", finite(a.spread)}};
}

Json fit_json(const EffectFit& fit) {
    Json effects = Json::array();
    for (const Effect& e : fit.effects)
        effects.push_back({{"factor", e.factor},
                           {"effect", finite(e.estimate)},
                           {"standard_error", finite(e.standard_error)},
                           {"t", finite(e.t)},
                           {"p_value", finite(e.p)},
                           {"interval_95", {finite(e.interval.low), finite(e.interval.high)}}});
    return {{"left_out", fit.left_out.empty() ? Json(nullptr) : Json(fit.left_out)},
            {"effects", effects},
            {"constant", fit.constant},
            {"sum_of_squares", fit.sum_of_squares},
            {"degrees_of_freedom", fit.degrees_of_freedom},
            {"spread", finite(fit.spread)}};
}

Json replay_json(const Replayed& r) {
    const Replay& p = r.replay;
    Json digits = Json::array(), mismatches = Json::array(), steps = Json::array();
    Json crossings = Json::array();
    for (const Recomputed& d : p.digits) {
        digits.push_back(digit_json(d));
        if (!d.agrees) mismatches.push_back(digit_json(d));
    }
    for (const AscentStep& s : p.steps)
        steps.push_back({{"factor", s.factor}, {"taken", s.taken}, {"by_effects", s.by_effects}});
    for (const Crossing& c : p.crossings)
        crossings.push_back({{r.published.orthogonal.factors[0], c.first},
                             {r.published.orthogonal.factors[1], finite(c.second)},
                             {"slope", finite(c.slope)}});
    return {{"compared", p.digits.size()},
            {"mismatches", mismatches},
            {"main_effects", means_json(p.means)},
            {"claimed_ranking", r.audit.ranking.claimed},
            {"ascent_steps", steps},
            {"orthogonal", variance_json(p.orthogonal)},
            {"interpolation",
             {{"slope", p.line.slope},
              {"intercept", p.line.intercept},
              {"solution", p.line.solution},
              {"at_printed_solution", p.line.at_printed}}},
            {"crossings", crossings},
            {"pooled_solution", finite(p.pooled_solution)},
            {"restored", r.published.restored},
            {"digits", digits}};
}

Json ratios_json(const std::vector<CensoredEffect>& effects, const char* name) {
    Json list = Json::array();
    for (const CensoredEffect& e : effects)
        list.push_back({{"factor", e.factor},
                        {name, finite(e.estimate)},
                        {"standard_error", finite(e.standard_error)}});
    return list;
}

Json failed_json(const Audit& a) {
    Json dropped = Json::array(), values = Json::array(), zeros = Json::array();
    Json implied = Json::array();
    for (const Imputed& i : a.imputed)
        values.push_back({{"value", i.value}, {"effects", i.effects}});
    for (const auto& zero : a.sign_changes) zeros.push_back(zero ? Json(*zero) : Json(nullptr));
    for (const ImpliedRange& r : a.implied)
        implied.push_back(
            {{"factor", r.factor}, {"low", finite(r.effect.low)}, {"high", finite(r.effect.high)}});
    for (const LevelMeans& m : a.means) dropped.push_back(finite(m.effect));
    Json json = {{"drop", dropped}, {"impute", values}, {"sign_changes_at", zeros}};
    if (a.censored)
        json["censored"] = {{"bound", a.censored->bound},
                            {"prior", a.censored->prior ? Json(*a.censored->prior) : Json(nullptr)},
                            {"effects", ratios_json(a.censored->effects, "effect")},
                            {"spread", finite(a.censored->spread)},
                            {"failed_predictions", a.censored->failed_predictions},
                            {"ranges_without_prior", implied}};
    if (a.feasibility)
        json["feasibility"] = {{"log_odds", ratios_json(a.feasibility->slopes, "low_to_high")},
                               {"probability_of_forming", a.feasibility->probability}};
    return json;
}

Json audit_json(const Replayed& r) {
    const Audit& a = r.audit;
    Json nulls = Json::array(), aliases = Json::array(), fits = Json::array();
    Json findings = Json::array();
    for (const NullVector& n : a.null_vectors) nulls.push_back(n.text);
    for (const Alias& alias : a.aliases) aliases.push_back(alias.text);
    for (const EffectFit& fit : a.fits) fits.push_back(fit_json(fit));
    for (const Observation& o : r.observations)
        findings.push_back({{"topic", o.topic},
                            {"name", o.name},
                            {"value", finite(o.value)},
                            {"unit", o.unit},
                            {"where", o.where},
                            {"judgement", scaling::to_string(o.judgement)},
                            {"text", o.text}});
    Json json = {{"runs", a.runs},
                 {"failed", a.failed},
                 {"terms", a.terms},
                 {"planned_rank", a.planned_rank},
                 {"rank", a.rank},
                 {"null_vectors", nulls},
                 {"estimable", a.estimable},
                 {"estimable_pairs", a.estimable_pairs},
                 {"planned_d_efficiency", a.planned_d_efficiency},
                 {"d_efficiency", a.d_efficiency},
                 {"aliases", aliases},
                 {"fits", fits},
                 {"analysis_of_variance", variance_json(a.variance)},
                 {"detectable_effect", a.detectable}};
    json["ranking"] = {{"claimed", a.ranking.claimed},
                       {"identifiable", a.ranking.identifiable},
                       {"why", a.ranking.why},
                       {"other_orders", a.ranking.other},
                       {"largest_t", a.ranking.largest_t},
                       {"t_needed", a.ranking.t_needed}};
    json["failed_runs"] = a.failed > 0 ? failed_json(a) : Json(nullptr);
    json["findings"] = findings;
    return json;
}

}  // namespace

Json to_json(const Replayed& r) {
    return {{"source", r.published.source},
            {"holds", r.holds()},
            {"replay", replay_json(r)},
            {"audit", audit_json(r)}};
}

}  // namespace reports
