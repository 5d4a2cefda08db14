// SPDX-License-Identifier: MIT
#include "reports/scaling_map_json.hpp"

#include "cases/json_tree.hpp"
#include "scaling/errors.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>

namespace reports {

namespace {

using cases::Value;
using verify::MapCell;
using verify::MapHeap;
using verify::MapQuantity;
using verify::MapSide;
using verify::ScalingMap;

constexpr const char* format = "similitude-scaling-map/1";

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json summary_json(const statistics::Summary& s) {
    return {{"n", s.count},
            {"mean", s.count > 0 ? finite(s.mean) : Json(nullptr)},
            {"standard_deviation", s.count > 1 ? finite(s.standard_deviation) : Json(nullptr)}};
}

Json quantity_json(const MapQuantity& q) {
    const bool tested = q.reference.count > 0 && q.scaled.count > 0;
    const auto known = [&](double value) { return tested ? finite(value) : Json(nullptr); };
    return {{"name", q.name},
            {"unit", q.unit},
            {"reference", summary_json(q.reference)},
            {"scaled", summary_json(q.scaled)},
            {"difference", known(q.difference)},
            {"interval", {known(q.interval.low), known(q.interval.high)}},
            {"margin", finite(q.margin)},
            {"verdict", to_string(q.verdict)},
            {"seeds_needed", q.seeds_needed ? Json(*q.seeds_needed) : Json(nullptr)}};
}

Json side_json(const MapSide& s) {
    return {{"base_over_grain", s.size_ratio},
            {"youngs_modulus_over_rho_g_d", s.elasticity},
            {"pull_off_in_grain_weights", s.bond},
            {"grains", s.grains},
            {"heaps", s.heaps},
            {"at_rest", s.at_rest},
            {"formed", s.formed}};
}

Json cell_json(const MapCell& c) {
    Json quantities = Json::array();
    for (const MapQuantity& q : c.quantities) quantities.push_back(quantity_json(q));
    return {{"study", c.study},
            {"rule", c.rule},
            {"bond", c.bond},
            {"factor", c.factor},
            {"verdict", to_string(c.verdict)},
            {"why", c.why},
            {"reference", side_json(c.reference)},
            {"scaled", side_json(c.scaled)},
            {"quantities", std::move(quantities)}};
}

Json margin_json(const verify::MapMargin& m) {
    return {{"name", m.name},
            {"unit", m.unit},
            {"margin", m.margin},
            {"relative", m.relative},
            {"reason", m.reason}};
}

Json heap_json(const MapHeap& h) {
    Json values = Json::array();
    for (const auto& value : h.values) values.push_back(value ? finite(*value) : Json(nullptr));
    return {{"name", h.name},
            {"seed", h.seed},
            {"setup", h.setup},
            {"git", h.git},
            {"at_rest", h.at_rest},
            {"formed", h.formed},
            {"missed", h.missed},
            {"values", std::move(values)},
            {"grains_on_base", h.grains_on_base},
            {"grain_steps", h.grain_steps},
            {"seconds", h.seconds}};
}

// === and back

// A number that may be unknown.
double number_or(const Value& v, double otherwise) {
    return v.kind == Value::Kind::null ? otherwise : v.number();
}

std::size_t whole(const Value& v) {
    const double number = v.number();
    if (!(number >= 0.0) || number != std::floor(number))
        cases::refuse(v, "must be a whole number", "take a file that similitude has written");
    return static_cast<std::size_t>(number);
}

verify::MapVerdict verdict_from(const Value& v) {
    const auto verdict = verify::map_verdict_named(v.text());
    if (!verdict)
        cases::refuse(v, "must be holds, breaks, not_decided or not_poured",
                      "take a file that similitude has written");
    return *verdict;
}

statistics::Summary summary_from(const Value& v) {
    return {number_or(v.at("mean"), 0.0), number_or(v.at("standard_deviation"), 0.0),
            whole(v.at("n"))};
}

MapQuantity quantity_from(const Value& v) {
    const Value& interval = v.at("interval");
    if (interval.items.size() != 2)
        cases::refuse(interval, "must be [low, high]", "take a file that similitude has written");
    MapQuantity q{.name = v.at("name").text(),
                  .unit = v.at("unit").text(),
                  .reference = summary_from(v.at("reference")),
                  .scaled = summary_from(v.at("scaled")),
                  .difference = number_or(v.at("difference"), 0.0),
                  .interval = {number_or(interval.items[0], -INFINITY),
                               number_or(interval.items[1], INFINITY)},
                  .margin = v.at("margin").number(),
                  .verdict = verdict_from(v.at("verdict")),
                  .seeds_needed = std::nullopt};
    if (v.at("seeds_needed").kind != Value::Kind::null)
        q.seeds_needed = whole(v.at("seeds_needed"));
    return q;
}

MapSide side_from(const Value& v) {
    return {.size_ratio = v.at("base_over_grain").number(),
            .elasticity = v.at("youngs_modulus_over_rho_g_d").number(),
            .bond = v.at("pull_off_in_grain_weights").number(),
            .grains = static_cast<int>(whole(v.at("grains"))),
            .heaps = whole(v.at("heaps")),
            .at_rest = whole(v.at("at_rest")),
            .formed = whole(v.at("formed"))};
}

MapCell cell_from(const Value& v) {
    MapCell c{.study = v.at("study").text(),
              .rule = v.at("rule").text(),
              .bond = v.at("bond").number(),
              .factor = v.at("factor").number(),
              .reference = side_from(v.at("reference")),
              .scaled = side_from(v.at("scaled")),
              .quantities = {},
              .verdict = verdict_from(v.at("verdict")),
              .why = v.at("why").text()};
    for (const Value& q : v.at("quantities").items) c.quantities.push_back(quantity_from(q));
    return c;
}

MapHeap heap_from(const Value& v) {
    MapHeap h{.name = v.at("name").text(),
              .seed = whole(v.at("seed")),
              .setup = v.has("setup") ? v.at("setup").text() : "",
              .git = v.has("git") ? v.at("git").text() : "",
              .at_rest = v.at("at_rest").boolean(),
              .formed = v.at("formed").boolean(),
              .missed = {},
              .values = {},
              .grains_on_base = v.at("grains_on_base").number(),
              .grain_steps = v.at("grain_steps").number(),
              .seconds = v.at("seconds").number()};
    for (const Value& m : v.at("missed").items) h.missed.push_back(m.text());
    for (const Value& x : v.at("values").items)
        h.values.push_back(x.kind == Value::Kind::null ? std::nullopt
                                                       : std::optional<double>(x.number()));
    return h;
}

}  // namespace

Json to_json(const ScalingMap& map, const Provenance& who) {
    Json cells = Json::array(), heaps = Json::array(), margins = Json::array(),
         impact_margins = Json::array(), studies = Json::array();
    for (const MapCell& c : map.cells) cells.push_back(cell_json(c));
    for (const MapHeap& h : map.heaps) heaps.push_back(heap_json(h));
    for (const verify::MapMargin& m : verify::map_margins()) margins.push_back(margin_json(m));
    for (const verify::MapMargin& m : verify::impact_margins())
        impact_margins.push_back(margin_json(m));
    return {{"format", format},
            {"tool", to_json(who)},
            {"extent", map.extent},
            {"reference_grains", map.reference_grains},
            {"first_seed", map.first_seed},
            {"heaps_planned", map.heaps_planned},
            {"heaps_stale", map.heaps_stale},
            {"grain_steps_planned", map.grain_steps_planned},
            {"margins", std::move(margins)},
            {"impact_margins", std::move(impact_margins)},
            {"cells", std::move(cells)},
            {"heaps", std::move(heaps)}};
}

ScalingMap read_scaling_map(const std::string& path) {
    const Value v = cases::read_json(path);
    if (!v.has("format") || v.at("format").text() != format)
        throw scaling::InvalidInput(scaling::mistake(
            path + ": format", v.has("format") ? v.at("format").as_written() : "nothing",
            std::string("must be \"") + format + "\"",
            "make the map with similitude verify scaling-map --json FILE"));
    ScalingMap map{.extent = v.at("extent").text(),
                   .reference_grains = v.at("reference_grains").number(),
                   .first_seed = whole(v.at("first_seed")),
                   .cells = {},
                   .heaps = {},
                   .heaps_planned = whole(v.at("heaps_planned")),
                   .heaps_stale = v.has("heaps_stale") ? whole(v.at("heaps_stale")) : 0,
                   .grain_steps_planned = v.at("grain_steps_planned").number()};
    for (const Value& c : v.at("cells").items) map.cells.push_back(cell_from(c));
    for (const Value& h : v.at("heaps").items) map.heaps.push_back(heap_from(h));
    return map;
}

}  // namespace reports
