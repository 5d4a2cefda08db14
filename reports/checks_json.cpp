// SPDX-License-Identifier: MIT
#include "reports/checks.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace reports {

namespace {

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json known(const std::optional<double>& value) { return value ? finite(*value) : Json(nullptr); }

Json check_json(const verify::Check& c) {
    return {{"name", c.name},         {"group", c.group},   {"expected", finite(c.expected)},
            {"got", finite(c.got)},   {"unit", c.unit},     {"tolerance", finite(c.tolerance)},
            {"relative", c.relative}, {"reason", c.reason}, {"source", c.source},
            {"passed", c.passed}};
}

Json bits_json(const verify::BitsCheck& b) {
    return {{"name",
             fmt::format("the pile scaled by h = {:g} under {} is the reference to the last bit",
                         b.h, b.scheme)},
            {"group", "bitwise similarity"},
            {"expected", fmt::format("{:016x}", b.reference)},
            {"got", fmt::format("{:016x}", b.scaled)},
            {"unit", "hash of the final state"},
            {"tolerance", 0},
            {"relative", false},
            {"reason", "all scale factors are powers of two, which round nothing"},
            {"source", ""},
            {"grains", b.grains},
            {"passed", b.equal}};
}

Json sample_json(const verify::PileSample& s) {
    return {{"seed", s.seed},
            {"formed", s.formed},
            {"at_rest", s.at_rest},
            {"angle_deg", known(s.angle_deg(rigs::Estimator::two_h_over_d))},
            {"packing_fraction", known(s.packing_fraction)},
            {"coordination", finite(s.coordination)},
            {"grains_on_base", s.grains_on_base},
            {"grains_lost", s.grains_lost},
            {"steps", s.steps},
            {"slept", finite(s.slept)},
            {"slept_while_fed", finite(s.slept_while_fed)},
            {"hash", fmt::format("{:016x}", s.hash)}};
}

Json side_json(const verify::Side& side) {
    Json samples = Json::array();
    for (const verify::PileSample& s : side.samples) samples.push_back(sample_json(s));
    return {{"label", side.label},
            {"diameter", finite(side.diameter)},
            {"gravity", finite(side.gravity)},
            {"youngs_modulus", finite(side.youngs_modulus)},
            {"work_of_adhesion", finite(side.work_of_adhesion)},
            {"pull_off_in_grain_weights", finite(side.bond_number)},
            {"youngs_modulus_over_rho_g_d", finite(side.elasticity)},
            {"samples", std::move(samples)}};
}

Json summary_json(const statistics::Summary& s) {
    return {{"mean", s.count > 0 ? finite(s.mean) : Json(nullptr)},
            {"standard_deviation", s.count > 1 ? finite(s.standard_deviation) : Json(nullptr)},
            {"count", s.count}};
}

Json quantity_json(const verify::Quantity& q) {
    Json json = {{"name", q.name},
                 {"unit", q.unit},
                 {"reference", summary_json(q.reference)},
                 {"scaled", summary_json(q.scaled)}};
    json["margin"] = finite(q.test.margin);
    json["alpha"] = finite(q.test.alpha);
    if (q.reference.count < 2 || q.scaled.count < 2) {
        json["reason"] = "fewer than two seeds on a side";
        return json;
    }
    json["difference"] = finite(q.test.difference);
    json["interval"] = {finite(q.test.interval.low), finite(q.test.interval.high)};
    json["p_value"] = finite(q.test.p);
    json["equivalent"] = q.test.equivalent;
    json["seeds_for_power"] = q.seeds_for_power > 0 ? Json(q.seeds_for_power) : Json(nullptr);
    return json;
}

}  // namespace

Json to_json(const verify::Comparison& c) {
    Json quantities = Json::array();
    for (const verify::Quantity& q : c.quantities) quantities.push_back(quantity_json(q));
    return {{"name", c.name},
            {"what_differs", c.what_differs},
            {"answer", verify::to_string(c.answer)},
            {"claimed", c.claims},
            {"must_differ", c.must_differ},
            {"quantities", std::move(quantities)},
            {"reference", side_json(c.reference)},
            {"scaled", side_json(c.scaled)}};
}

Json to_json(const Verification& v) {
    const Verdict verdict = verdict_of(v);
    Json checks = Json::array(), comparisons = Json::array(), findings = Json::array();
    for (const verify::Check& c : v.checks) checks.push_back(check_json(c));
    if (v.similarity) {
        for (const verify::BitsCheck& b : v.similarity->bits) checks.push_back(bits_json(b));
        findings = to_json(v.similarity->findings);
    }
    for (const verify::Comparison* c : comparisons_of(v)) comparisons.push_back(to_json(*c));
    Json json = {{"verdict", to_string(verdict.answer)},
                 {"why", verdict.why},
                 {"checks", std::move(checks)},
                 {"comparisons", std::move(comparisons)},
                 {"findings", std::move(findings)}};
    if (v.similarity) json["heaps_by"] = heaps_by(*v.similarity);
    if (v.sleep)
        json["sleep"] = {{"experiment", v.sleep->experiment},
                         {"grains", v.sleep->grains},
                         {"slept", finite(v.sleep->saved.whole)},
                         {"slept_while_fed", finite(v.sleep->saved.while_fed)}};
    return json;
}

}  // namespace reports
