// SPDX-License-Identifier: MIT
#include "prove/case_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace prove {
namespace {

std::string number(double x) { return std::isfinite(x) ? fmt::format("{:.10g}", x) : "null"; }

template <class List, class Write>
std::string list(const List& items, const Write& write) {
    std::string all;
    for (const auto& item : items) all += (all.empty() ? "" : ", ") + write(item);
    return fmt::format("[{}]", all);
}

std::string words(const std::vector<std::string>& items) {
    return list(items, [](const std::string& s) { return json_text(s); });
}

std::string parameter(const TrueParameter& p) {
    return fmt::format(
        "\n    {{\"effect\": {}, \"channel\": {}, \"name\": {}, \"value\": {}, \"unit\": {}, "
        "\"oracle_error\": {}}}",
        json_text(p.effect), json_text(p.channel), json_text(p.name), number(p.value),
        json_text(p.unit), number(p.oracle_error));
}

std::string interval(const TrueInterval& i) {
    return fmt::format(
        "\n    {{\"experiment\": {}, \"channel\": {}, \"ordinate\": {}, \"unit\": {}, \"from\": "
        "{}, "
        "\"to\": {}, \"share\": {}, \"sign\": {}}}",
        json_text(i.experiment), json_text(i.channel), json_text(i.ordinate), json_text(i.unit),
        number(i.from), number(i.to), number(i.share), i.sign);
}

}  // namespace

std::string key_text(const Key& k) {
    return fmt::format(
        "{{\n  \"format\": \"similitude-key/1\",\n  \"case\": {}, \"kind\": {}, \"subkind\": {}, "
        "\"rig\": {},\n  \"effects\": {}, \"channels\": {}, \"outside\": {},\n"
        "  \"parameters\": {},\n"
        "  \"idr\": {}, \"n_eff\": {}, \"lambda\": {}, \"oracle_power\": {},\n"
        "  \"oracle_statistic\": {}, \"oracle_freedom\": {},\n"
        "  \"separation\": {}, \"nearest_wrong\": {}, \"nearest_wrong_channel\": {},\n"
        "  \"pair_separation\": {}, \"lambda_given_other\": {},\n"
        "  \"intervals\": {},\n  \"recorded_channels\": {},\n"
        "  \"oracle_held_out\": {}, \"base_held_out\": {}, \"noise_floor\": {},\n"
        "  \"noise_correlation\": {}, \"noise_heavy\": {}\n}}\n",
        json_text(k.name), json_text(to_string(k.kind)), json_text(k.subkind), json_text(k.rig),
        words(k.effects), words(k.channels), json_text(k.outside), list(k.parameters, parameter),
        number(k.idr), number(k.n_eff), number(k.lambda), number(k.oracle_power),
        number(k.oracle_statistic), k.oracle_freedom, number(k.separation.d),
        json_text(k.separation.effect), json_text(k.separation.channel), number(k.pair_separation),
        list(k.lambda_given_other, number), list(k.intervals, interval), k.recorded_channels,
        number(k.oracle_held_out), number(k.base_held_out), number(k.noise_floor),
        number(k.noise.correlation), k.noise.heavy ? "true" : "false");
}

}  // namespace prove
