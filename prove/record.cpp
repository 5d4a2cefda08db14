// SPDX-License-Identifier: MIT
#include "prove/record.hpp"

#include "prove/case_text.hpp"
#include "prove/dice.hpp"
#include "prove/verdict.hpp"
#include "scaling/errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace prove {
namespace {

using cases::Value;

struct Field {
    const char* name;
    double Setup::*place;
};
constexpr std::array<Field, 8> condition_fields{
    {{"height", &Setup::height},
     {"speed", &Setup::speed},
     {"horizontal_speed", &Setup::horizontal_speed},
     {"spin", &Setup::spin},
     {"release_time", &Setup::release_time},
     {"angle", &Setup::angle},
     {"preload", &Setup::preload},
     {"cantilever_stiffness", &Setup::cantilever_stiffness}}};
constexpr std::array<Field, 4> grain_fields{{{"diameter", &Setup::diameter},
                                             {"density", &Setup::density},
                                             {"youngs_modulus", &Setup::youngs_modulus},
                                             {"poisson_ratio", &Setup::poisson_ratio}}};

[[noreturn]] void refuse_word(const std::string& where, const std::string& word) {
    throw scaling::InvalidInput(scaling::mistake("next_experiment." + where, '"' + word + '"',
                                                 "must be what the rig has",
                                                 "see docs/case.md, experiments"));
}

Rig rig_of(const std::string& word) {
    for (const Rig rig : {Rig::drop, Rig::incline, Rig::impact, Rig::pull_off})
        if (word == to_string(rig)) return rig;
    refuse_word("rig", word);
}

std::vector<Channel> channels_of(Rig rig, const Value& wish) {
    static const std::array<std::vector<Channel>, 4> known{
        {{Channel::z, Channel::x},
         {Channel::s, Channel::spin},
         {Channel::rebound_angle, Channel::normal_restitution, Channel::tangential_restitution,
          Channel::rebound_spin},
         {Channel::force}}};
    const std::vector<Channel>& own = known[static_cast<std::size_t>(rig)];
    std::vector<Channel> wanted;
    if (wish.has("channels")) {
        for (const Value& item : wish.at("channels").items) {
            const auto found = std::find_if(own.begin(), own.end(), [&](Channel c) {
                return item.written_text == to_string(c);
            });
            if (found == own.end()) refuse_word("channels", item.written_text);
            wanted.push_back(*found);
        }
    }
    return wanted.empty() ? std::vector<Channel>{own.front()} : wanted;
}

void set_fields(const Value& object, const auto& fields, const char* where, Setup& s) {
    for (const auto& [key, value] : object.members) {
        if (key == "counterpart") {
            s.grain_on_grain = value.written_text == "grain";
            continue;
        }
        const auto found = std::find_if(fields.begin(), fields.end(),
                                        [&key = key](const Field& f) { return key == f.name; });
        if (found == fields.end()) refuse_word(where, key);
        s.*(found->place) = si_value(value);
    }
}

void set_ordinates(const Value& wish, Setup& s) {
    if (!wish.has("ordinate")) return;
    const Value& ordinate = wish.at("ordinate");
    if (!ordinate.has("from") || !ordinate.has("to")) return;
    double from = si_value(ordinate.at("from")), to = si_value(ordinate.at("to"));
    if (!std::isfinite(from) || !std::isfinite(to)) return;
    if (from > to) std::swap(from, to);
    const int wished =
        ordinate.has("rows") ? static_cast<int>(ordinate.at("rows").written_number) : 120;
    const int rows = std::clamp(s.rig == Rig::pull_off ? wished / 2 : wished, 8, 400);
    s.at.clear();
    s.retract.clear();
    for (int k = 0; k < rows; ++k)
        s.at.push_back(rounded(from + (to - from) * k / (rows - 1.0), 6));
    if (s.rig != Rig::pull_off) return;
    std::vector<double> in(s.at.rbegin(), s.at.rend());
    s.retract.assign(in.size(), false);
    s.retract.insert(s.retract.end(), s.at.size(), true);
    in.insert(in.end(), s.at.begin(), s.at.end());
    s.at = in;
}

double noise_of(const BlindCase& blind, const Value& wish, Channel c,
                const std::vector<double>& ranges) {
    for (const Setup& s : blind.skeleton.stated)
        for (std::size_t k = 0; k < s.recorded.size(); ++k)
            if (s.recorded[k] == c) return s.noise[k];
    if (wish.has("noise") && wish.at("noise").has(to_string(c))) {
        const double wished = si_value(wish.at("noise").at(to_string(c)));
        if (std::isfinite(wished)) return wished;
    }
    return rounded(std::max(0.02 * ranges[static_cast<std::size_t>(c)], 1e-15), 3);
}

}  // namespace

std::map<std::string, std::string> record(const BlindCase& blind, std::uint64_t seed,
                                          const Value& wish) {
    const Setup& common = blind.skeleton.stated.front();
    Setup s = common;
    if (wish.has("rig")) s.rig = rig_of(wish.at("rig").text());
    if (s.rig != common.rig) {
        for (const Field& f : condition_fields) s.*f.place = 0.0;
        s.at.clear();
        s.retract.clear();
    }
    s.id = "asked-1";
    s.held_out = false;
    s.base_line = s.base_line_slope = 0.0;
    if (wish.has("conditions"))
        set_fields(wish.at("conditions"), condition_fields, "conditions", s);
    if (wish.has("grain")) set_fields(wish.at("grain"), grain_fields, "grain", s);
    s.recorded = channels_of(s.rig, wish);
    set_ordinates(wish, s);
    if (s.at.empty()) refuse_word("from", "nothing");
    std::vector<double> y = predict(blind.world, s);
    const std::vector<double> ranges = channel_ranges(
        {s}, Eigen::Map<const Eigen::VectorXd>(y.data(), static_cast<Eigen::Index>(y.size())));
    s.noise.clear();
    for (const Channel c : s.recorded) s.noise.push_back(noise_of(blind, wish, c, ranges));
    Dice dice(seed, static_cast<std::uint64_t>(blind.number), 2);
    const Noise& noise = blind.skeleton.noise;
    const double rest = std::sqrt(1.0 - noise.correlation * noise.correlation);
    for (std::size_t c = 0; c < s.recorded.size(); ++c) {
        double before = 0.0;
        for (std::size_t row = 0; row < s.at.size(); ++row) {
            const double draw = noise.heavy ? dice.student4() : dice.normal();
            before = row == 0 ? draw : noise.correlation * before + rest * draw;
            y[c * s.at.size() + row] += s.noise[c] * before;
        }
    }
    std::map<std::string, std::string> files = blind.files;
    files[s.id + ".csv"] = recording_text(s, y.data());
    std::string& json = files.at("case.json");
    json.insert(json.rfind("\n  ]\n}"),
                ",\n    " + experiment_text(s, common, {}, 0, blind.skeleton.states_noise, false));
    return files;
}

}  // namespace prove
