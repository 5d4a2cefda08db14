// SPDX-License-Identifier: MIT
#include "cases/rig_table.hpp"

#include "cases/messages.hpp"
#include "scaling/errors.hpp"

#include <algorithm>

namespace cases {
namespace {

using Words = std::vector<std::string>;

Condition quantity(std::string name, std::string unit, Domain domain, bool required = false) {
    return {
        .name = std::move(name), .unit = std::move(unit), .domain = domain, .required = required};
}
Condition word(std::string name, Words words, bool required) {
    return {.name = std::move(name), .required = required, .words = std::move(words)};
}

RigRule drop() {
    return {
        "drop",
        {quantity("height", "m", Domain::not_negative, true), quantity("speed", "m/s", Domain::any),
         quantity("horizontal_speed", "m/s", Domain::any), quantity("spin", "rad/s", Domain::any),
         quantity("release_time", "s", Domain::any)},
        {{"t", {"s"}}, {"z", {"m"}}, {"x", {"m"}}},
        {{"t", "z"}}};
}

RigRule incline() {
    return {"incline",
            {quantity("angle", "rad", Domain::steepness, true),
             quantity("speed", "m/s", Domain::any), quantity("spin", "rad/s", Domain::any)},
            {{"t", {"s"}}, {"s", {"m"}}, {"spin", {"rad/s"}}},
            {{"t", "s"}}};
}

RigRule impact() {
    return {
        "impact",
        {quantity("speed", "m/s", Domain::positive, true), quantity("spin", "rad/s", Domain::any)},
        {{"angle", {"rad"}},
         {"rebound_angle", {"rad"}},
         {"normal_restitution", {"1"}},
         {"tangential_restitution", {"1"}},
         {"rebound_spin", {"rad/s"}}},
        {{"angle", "rebound_angle"},
         {"angle", "normal_restitution"},
         {"angle", "tangential_restitution"},
         {"angle", "rebound_spin"}}};
}

RigRule pull_off() {
    return {"pull_off",
            {word("counterpart", {"plate", "grain"}, true),
             quantity("preload", "N", Domain::not_negative, true),
             quantity("speed", "m/s", Domain::positive),
             quantity("cantilever_stiffness", "N/m", Domain::positive),
             quantity("deflection_sensitivity", "m/V", Domain::positive),
             quantity("contact_displacement", "m", Domain::any)},
            {{"separation", {"m"}},
             {"displacement", {"m"}},
             {"force", {"N"}},
             {"branch", {}, {"approach", "retract"}}},
            {{"separation", "force", "branch"}, {"displacement", "force", "branch"}}};
}

RigRule pile() {
    const Words estimators{"flank_20_80", "cone",   "two_h_over_d",
                           "silhouette",  "volume", "protractor"};
    Condition grains{
        .name = "grains", .required = true, .count = true, .words = {"until_it_spills"}};
    Condition funnel{.name = "funnel",
                     .members = {quantity("outlet_diameter", "m", Domain::positive, true),
                                 quantity("top_diameter", "m", Domain::positive, true),
                                 quantity("height", "m", Domain::positive, true),
                                 quantity("outlet_height", "m", Domain::positive, true),
                                 Condition{.name = "material", .text = true}}};
    Condition shift = quantity("shift", "m", Domain::any);
    shift.in_list = 3;
    Condition mesh{.name = "mesh",
                   .members = {Condition{.name = "file", .required = true, .text = true},
                               Condition{.name = "unit", .text = true}, std::move(shift),
                               Condition{.name = "material", .text = true}},
                   .several = true};
    return {"pile",
            {word("base", {"flat", "flat_with_rim", "glued_grains"}, true),
             quantity("base_diameter", "m", Domain::positive, true),
             Condition{.name = "base_material", .text = true}, std::move(grains),
             quantity("rim_height", "m", Domain::positive),
             quantity("drop_height", "m", Domain::positive),
             quantity("feed_diameter", "m", Domain::positive),
             quantity("feed_rate", "1/s", Domain::positive), std::move(funnel), std::move(mesh),
             word("estimator", estimators, false)},
            {{"azimuth", {"rad"}},
             {"r", {"m"}},
             {"z", {"m"}},
             {"t", {"s"}},
             {"angle_of_repose", {"rad"}},
             {"estimator", {}, estimators}},
            {{"azimuth", "r", "z"}, {"angle_of_repose"}}};
}

RigRule discharge() {
    return {"discharge",
            {word("silo_shape", {"cylinder", "box"}, true),
             quantity("silo_diameter", "m", Domain::positive),
             quantity("width", "m", Domain::positive), quantity("depth", "m", Domain::positive),
             quantity("outlet_diameter", "m", Domain::positive),
             quantity("outlet_width", "m", Domain::positive),
             quantity("outlet_depth", "m", Domain::positive),
             Condition{.name = "grains", .count = true},
             quantity("fill_height", "m", Domain::positive)},
            {{"t", {"s"}}, {"m", {"kg", "1"}}},
            {{"t", "m"}}};
}

RigRule column() {
    Condition lift = quantity("lift_speed", "m/s", Domain::positive);
    lift.words = {"instant"};
    return {"column",
            {quantity("column_radius", "m", Domain::positive, true),
             quantity("column_height", "m", Domain::positive, true), std::move(lift)},
            {{"t", {"s"}}, {"r", {"m"}}, {"z", {"m"}}},
            {{"t", "r", "z"}}};
}

RigRule drum() {
    return {"drum",
            {quantity("drum_diameter", "m", Domain::positive, true),
             quantity("drum_length", "m", Domain::positive, true),
             quantity("rotation_speed", "rad/s", Domain::any, true),
             quantity("fill_fraction", "1", Domain::unit_interval, true)},
            {{"t", {"s"}}, {"angle", {"rad"}}, {"depth", {"m"}}, {"velocity", {"m/s"}}},
            {{"t", "angle"}, {"depth", "velocity"}}};
}

void check_condition(const Condition& rule, const Value& value);

void check_list(const Condition& rule, const Value& list) {
    Condition one = rule;
    one.several = false;
    one.in_list = 0;
    if (list.kind != Value::Kind::list || list.items.empty() ||
        (rule.in_list > 0 && list.items.size() != rule.in_list)) {
        refuse(list,
               "must be a list" + (rule.in_list > 0 ? " of " + std::to_string(rule.in_list)
                                                    : std::string(" of one or more")),
               "write [ ] around them, commas between");
    }
    for (const Value& item : list.items) check_condition(one, item);
}

void check_condition(const Condition& rule, const Value& value) {
    if (rule.in_list > 0 || (rule.several && value.kind == Value::Kind::list)) {
        check_list(rule, value);
    } else if (rule.text) {
        value.text();
    } else if (!rule.members.empty()) {
        Words names;
        for (const Condition& member : rule.members) names.push_back(member.name);
        check_keys(value, names);
        for (const Condition& member : rule.members) {
            if (member.required || value.has(member.name))
                check_condition(member, value.at(member.name));
        }
    } else if (rule.count && value.kind == Value::Kind::number) {
        value.count();
    } else if (!rule.unit.empty() &&
               (rule.words.empty() || nearest(value.written_text, rule.words).empty())) {
        checked_pair(value, rule.unit, rule.domain);
    } else if (rule.count && rule.words.empty()) {
        value.count();
    } else {
        checked_word(value, rule.words);
    }
}

// `key` must not be there; `rule` says why.
void forbid(const Value& conditions, const std::string& key, const std::string& rule) {
    if (conditions.has(key)) refuse(conditions.at(key), rule, "remove \"" + key + "\"");
}

// Exactly one of the two.
void one_of_two(const Value& conditions, const std::string& first, const std::string& second) {
    if (!conditions.has(first) && !conditions.has(second)) {
        refuse(conditions, "must hold " + first + " or " + second, "add one of them");
    }
    if (conditions.has(first)) forbid(conditions, second, "must not stand beside " + first);
}

void check_pile(const Value& conditions) {
    if (conditions.at("base").text() != "flat_with_rim") {
        forbid(conditions, "rim_height", "must belong to the base flat_with_rim");
    }
    if (conditions.at("base").text() == "glued_grains")
        forbid(conditions, "base_material", "must belong to a flat base: glued grains are grains");
    if (conditions.has("mesh") && !conditions.has("funnel")) {
        for (const char* key : {"drop_height", "feed_diameter"}) {
            if (conditions.has(key)) continue;
            throw scaling::InvalidInput(scaling::mistake(conditions.where + "." + key, "nothing",
                                                         "must be given beside a mesh",
                                                         "say where the grains appear"));
        }
    }
    if (!conditions.has("funnel")) return;
    forbid(conditions, "feed_diameter", "must not stand beside a funnel");
    forbid(conditions, "drop_height", "must not stand beside a funnel");
    const Value& funnel = conditions.at("funnel");
    if (funnel.at("outlet_diameter").quantity<scaling::Length>() >
        funnel.at("top_diameter").quantity<scaling::Length>()) {
        refuse(funnel.at("outlet_diameter"), "must not be wider than top_diameter",
               "exchange the two");
    }
}

void check_discharge(const Value& conditions) {
    const bool box = conditions.at("silo_shape").text() == "box";
    if (box) {
        forbid(conditions, "silo_diameter", "must belong to a cylinder");
        conditions.at("width");
        conditions.at("depth");
    } else {
        forbid(conditions, "width", "must belong to a box");
        forbid(conditions, "depth", "must belong to a box");
        conditions.at("silo_diameter");
    }
    one_of_two(conditions, "outlet_diameter", "outlet_width");
    if (!conditions.has("outlet_width"))
        forbid(conditions, "outlet_depth", "must stand beside outlet_width");
    one_of_two(conditions, "grains", "fill_height");
}

}  // namespace

const std::vector<RigRule>& rig_rules() {
    static const std::vector<RigRule> table{drop(), incline(),   impact(), pull_off(),
                                            pile(), discharge(), column(), drum()};
    return table;
}

std::vector<std::string> rig_names() {
    std::vector<std::string> names;
    for (const RigRule& rule : rig_rules()) names.push_back(rule.name);
    return names;
}

const RigRule& rig_rule(const std::string& name) {
    for (const RigRule& rule : rig_rules()) {
        if (rule.name == name) return rule;
    }
    throw scaling::InvalidParameter(scaling::mistake("rig", in_quotes(name), "must be a known rig",
                                                     suggestion(name, rig_names())));
}

const ChannelRule* find_channel(const RigRule& rig, const std::string& name) {
    for (const ChannelRule& channel : rig.channels) {
        if (channel.name == name) return &channel;
    }
    return nullptr;
}

std::vector<std::string> channel_names(const RigRule& rig) {
    std::vector<std::string> names;
    for (const ChannelRule& channel : rig.channels) names.push_back(channel.name);
    return names;
}

void check_conditions(const RigRule& rig, const Value& conditions) {
    Condition all{.name = "conditions", .members = rig.conditions};
    check_condition(all, conditions);
    if (rig.name == "pile") check_pile(conditions);
    if (rig.name == "discharge") check_discharge(conditions);
}

bool needs_plate(const RigRule& rig, const Value& conditions) {
    if (rig.name == "pull_off") return conditions.at("counterpart").text() == "plate";
    if (rig.name != "pile") return true;
    const auto of_plate = [](const Value& owner, const char* key) {
        return !owner.has(key) || owner.at(key).text() == "plate";
    };
    if (conditions.at("base").text() != "glued_grains" && of_plate(conditions, "base_material"))
        return true;
    if (conditions.has("funnel") && of_plate(conditions.at("funnel"), "material")) return true;
    if (!conditions.has("mesh")) return false;
    const Value& mesh = conditions.at("mesh");
    if (mesh.kind != Value::Kind::list) return of_plate(mesh, "material");
    return std::any_of(mesh.items.begin(), mesh.items.end(),
                       [&](const Value& one) { return of_plate(one, "material"); });
}

}  // namespace cases
