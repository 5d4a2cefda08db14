// SPDX-License-Identifier: MIT
#include "prove/verdict.hpp"

#include "cases/json_tree.hpp"
#include "cases/units.hpp"
#include "prove/case_text.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>

namespace prove {
namespace {

using cases::Value;
using Type = Value::Kind;

double number(const Value& v) {
    return v.kind == Type::number ? v.written_number : std::numeric_limits<double>::quiet_NaN();
}
double number(const Value& object, const char* key) {
    return object.has(key) ? number(object.at(key)) : std::numeric_limits<double>::quiet_NaN();
}
std::string text(const Value& object, const char* key) {
    return object.has(key) && object.at(key).kind == Type::text ? object.at(key).written_text : "";
}
std::vector<Value> items(const Value& object, const char* key) {
    return object.has(key) ? object.at(key).items : std::vector<Value>{};
}
std::vector<std::string> words(const Value& object, const char* key) {
    std::vector<std::string> all;
    for (const Value& v : items(object, key)) all.push_back(v.written_text);
    return all;
}

double factor_of(const std::string& unit, const std::string& where) {
    return unit.empty() || unit == "1" ? 1.0 : cases::parse_unit(unit, where).factor;
}

JudgedEffect effect_of(const Value& v) {
    JudgedEffect e{.name = text(v, "name"), .probability = number(v, "probability")};
    e.named = v.has("named") && v.at("named").kind == Type::boolean && v.at("named").boolean();
    if (!v.has("parameters")) return e;
    for (const auto& [name, p] : v.at("parameters").members) {
        if (p.kind != Type::object || !p.has("value")) continue;
        const double factor = factor_of(text(p, "unit"), p.where);
        Estimate estimate{name, number(p, "value") * factor, NAN, NAN};
        const std::vector<Value> ends = items(p, "ci90");
        if (ends.size() == 2)
            estimate.low = number(ends[0]) * factor, estimate.high = number(ends[1]) * factor;
        e.parameters.push_back(estimate);
    }
    return e;
}

void demand(const Value& file, const char* format) {
    if (text(file, "format") == format) return;
    throw scaling::InvalidInput(
        scaling::mistake(file.where + ": format", '"' + text(file, "format") + '"',
                         std::string("must be \"") + format + '"', "hand over the right folder"));
}

template <class Read>
auto read_all(const std::string& directory, const Read& read) {
    std::map<std::string, decltype(read(std::string()))> all;
    if (!std::filesystem::is_directory(directory)) return all;
    for (const auto& entry : std::filesystem::directory_iterator(directory)) {
        if (entry.path().extension() != ".json") continue;
        try {
            all.emplace(entry.path().stem().string(), read(entry.path().string()));
        } catch (const scaling::InvalidInput&) {
            continue;  // cut off while it was written, or no such file: it is missing
        }
    }
    return all;
}

std::string quoted_list(const std::vector<std::string>& all) {
    std::string joined;
    for (const std::string& s : all) joined += (joined.empty() ? "" : ", ") + json_text(s);
    return fmt::format("[{}]", joined);
}

}  // namespace

double si_value(const Value& v) {
    if (v.kind == Type::number) return v.written_number;
    if (v.kind == Type::object && v.has("value")) return si_value(v.at("value"));
    if (v.kind != Type::text) return std::numeric_limits<double>::quiet_NaN();
    char* end = nullptr;
    const double value = std::strtod(v.written_text.c_str(), &end);
    while (*end == ' ') ++end;
    return value * factor_of(end, v.where);
}

bool Verdict::alarm() const { return verdict != "consistent" && verdict != "undecided"; }

std::vector<std::string> Verdict::named() const {
    std::vector<std::string> all;
    for (const JudgedEffect& e : effects)
        if (e.named && e.name != "unknown") all.push_back(e.name);
    std::sort(all.begin(), all.end());
    return all;
}

Verdict read_verdict(const std::string& path) {
    const Value file = cases::read_json(path);
    demand(file, "similitude-verdict/1");
    Verdict v{.verdict = text(file, "verdict")};
    for (const Value& p : items(file, "located"))
        v.located.push_back({text(p, "experiment"), text(p, "channel"), text(p, "variable"),
                             p.has("from") ? si_value(p.at("from")) : NAN,
                             p.has("to") ? si_value(p.at("to")) : NAN});
    for (const Value& h : items(file, "hypotheses")) {
        std::vector<std::string> names = words(h, "effects");
        std::sort(names.begin(), names.end());
        v.hypotheses.push_back({names, number(h, "probability")});
    }
    for (const Value& e : items(file, "effects")) v.effects.push_back(effect_of(e));
    if (file.has("held_out") && file.at("held_out").kind == Type::object) {
        const double x = number(file.at("held_out"), "nrmse_extended");
        if (std::isfinite(x)) v.held_out_extended = x;
    }
    if (file.has("next_experiment") && file.at("next_experiment").kind == Type::object)
        v.between = words(file.at("next_experiment"), "between");
    return v;
}

Key read_key(const std::string& path) {
    const Value file = cases::read_json(path);
    demand(file, "similitude-key/1");
    Key k;
    k.name = text(file, "case");
    k.kind = kind_of(text(file, "kind"));
    k.subkind = text(file, "subkind"), k.rig = text(file, "rig"), k.outside = text(file, "outside");
    k.effects = words(file, "effects"), k.channels = words(file, "channels");
    for (const Value& p : items(file, "parameters"))
        k.parameters.push_back({text(p, "effect"), text(p, "channel"), text(p, "name"),
                                text(p, "unit"), number(p, "value"), number(p, "oracle_error")});
    k.idr = number(file, "idr"), k.n_eff = number(file, "n_eff");
    k.lambda = number(file, "lambda"), k.oracle_power = number(file, "oracle_power");
    k.oracle_statistic = number(file, "oracle_statistic");
    k.oracle_freedom = static_cast<int>(number(file, "oracle_freedom"));
    k.separation = {number(file, "separation"), text(file, "nearest_wrong"),
                    text(file, "nearest_wrong_channel")};
    k.pair_separation = number(file, "pair_separation");
    for (const Value& v : items(file, "lambda_given_other"))
        k.lambda_given_other.push_back(number(v));
    for (const Value& i : items(file, "intervals"))
        k.intervals.push_back({text(i, "experiment"), text(i, "channel"), text(i, "ordinate"),
                               text(i, "unit"), number(i, "from"), number(i, "to"),
                               number(i, "share"), static_cast<int>(number(i, "sign"))});
    k.recorded_channels = static_cast<int>(number(file, "recorded_channels"));
    k.oracle_held_out = number(file, "oracle_held_out");
    k.base_held_out = number(file, "base_held_out");
    k.noise_floor = number(file, "noise_floor");
    k.noise.correlation = number(file, "noise_correlation");
    k.noise.heavy = file.at("noise_heavy").boolean();
    return k;
}

Verdicts read_verdicts(const std::string& directory) {
    return read_all(directory, [](const std::string& path) { return read_verdict(path); });
}

Keys read_keys(const std::string& directory) {
    return read_all(directory, [](const std::string& path) { return read_key(path); });
}

std::string verdict_text(const std::string& case_name, const Verdict& v) {
    std::string hypotheses, effects;
    for (const Hypothesis& h : v.hypotheses)
        hypotheses +=
            fmt::format("{}\n    {{\"effects\": {}, \"probability\": {:.6g}}}",
                        hypotheses.empty() ? "" : ",", quoted_list(h.effects), h.probability);
    for (const JudgedEffect& e : v.effects) {
        std::string parameters;
        for (const Estimate& p : e.parameters) {
            const bool interval = std::isfinite(p.low) && std::isfinite(p.high);
            parameters += fmt::format(
                "{}{}: {{\"value\": {:.9g}{}}}", parameters.empty() ? "" : ", ", json_text(p.name),
                p.value,
                interval ? fmt::format(", \"ci90\": [{:.9g}, {:.9g}]", p.low, p.high) : "");
        }
        effects += fmt::format(
            "{}\n    {{\"name\": {}, \"probability\": {:.6g}, \"named\": {}, \"parameters\": "
            "{{{}}}}}",
            effects.empty() ? "" : ",", json_text(e.name), e.probability, e.named, parameters);
    }
    const std::string held_out =
        v.held_out_extended
            ? fmt::format(",\n  \"held_out\": {{\"nrmse_extended\": {:.6g}}}", *v.held_out_extended)
            : "";
    return fmt::format(
        "{{\n  \"format\": \"similitude-verdict/1\", \"case\": {}, \"verdict\": {},\n"
        "  \"located\": [],\n  \"hypotheses\": [{}],\n  \"effects\": [{}]{}\n}}\n",
        json_text(case_name), json_text(v.verdict), hypotheses, effects, held_out);
}

}  // namespace prove
