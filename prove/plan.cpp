// SPDX-License-Identifier: MIT
// Which kind of case a number is. Blocks of 60: 20 nulls, 25 singles, 6 look-alikes, 4 pairs, 3 outside, 2 numerical, in an
// order of their own for each seed and block; 1200 cases are 20 such blocks.
#include "prove/blind_case.hpp"
#include "prove/dice.hpp"
#include "scaling/errors.hpp"

#include <array>
#include <utility>

namespace prove {
namespace {

struct Share {
    Kind kind;
    int count;
};
constexpr std::array<Share, 6> shares{{{Kind::null, 20},
                                       {Kind::single, 25},
                                       {Kind::look_alike, 6},
                                       {Kind::pair, 4},
                                       {Kind::outside, 3},
                                       {Kind::numerical, 2}}};
constexpr int block = 60;

struct Place {
    const char* effect;
    std::vector<Rig> rigs;  // often twice
};

// Every effect with the rigs in which it can be seen, the better ones more often.
const std::vector<Place>& places() {
    using enum Rig;
    static const std::vector<Place> table{
        {"air_drag", {drop, drop, drop, incline}},
        {"buoyancy", {drop, drop, incline}},
        {"adhesion", {pull_off, pull_off, incline, incline, drop}},
        {"van_der_waals", {pull_off}},
        {"capillary_bridge", {pull_off, incline, drop}},
        {"electrostatic", {pull_off, incline, drop}},
        {"rolling_resistance", {incline, incline, impact}},
        {"viscoelastic_restitution", {drop, impact}},
        {"plastic_restitution", {drop, impact}},
        {"velocity_dependent_friction", {incline, impact, drop}},
        {"tangential_compliance", {impact, impact, drop}},
        {"tilt", {incline, drop}},
        {"vibration", {drop}},
        {"measurement_scale", {drop, incline, impact, pull_off}},
        {"measurement_offset", {drop, incline, impact, pull_off}},
        {"time_base", {drop, incline}}};
    return table;
}

// Pairs that few recordings tell apart, by the effect concealed.
const std::vector<Place>& confusable() {
    using enum Rig;
    static const std::vector<Place> table{{"air_drag", {drop, incline}},
                                          {"buoyancy", {incline, drop}},
                                          {"adhesion", {incline}},
                                          {"capillary_bridge", {incline}},
                                          {"electrostatic", {pull_off, incline}},
                                          {"viscoelastic_restitution", {drop, impact}},
                                          {"plastic_restitution", {drop, impact}},
                                          {"measurement_scale", {drop, incline}},
                                          {"time_base", {incline, drop}},
                                          {"tilt", {incline}},
                                          {"rolling_resistance", {incline}},
                                          {"measurement_offset", {pull_off, drop}}};
    return table;
}

// Position of the number among those of its kind, and its kind.
std::pair<Kind, int> kind_and_index(std::uint64_t seed, int number) {
    const int which = (number - 1) / block, place = (number - 1) % block;
    std::vector<std::pair<Kind, int>> order;
    for (const Share& s : shares)
        for (int k = 0; k < s.count; ++k) order.emplace_back(s.kind, which * s.count + k);
    Dice dice(seed, static_cast<std::uint64_t>(which), 7);
    for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[dice.pick(k)]);
    return order[static_cast<std::size_t>(place)];
}

}  // namespace

const char* to_string(Kind k) {
    static constexpr std::array<const char*, 6> names{"null", "single",  "look_alike",
                                                      "pair", "outside", "numerical"};
    return names[static_cast<std::size_t>(k)];
}

Kind kind_of(const std::string& word) {
    for (const Share& s : shares)
        if (word == to_string(s.kind)) return s.kind;
    throw scaling::InvalidInput(
        scaling::mistake("kind", '"' + word + '"', "must be a kind of blind case",
                         "known: null, single, look_alike, pair, outside, numerical"));
}

Plan plan(std::uint64_t seed, int number) {
    const auto [kind, index] = kind_and_index(seed, number);
    Dice dice(seed, static_cast<std::uint64_t>(number), 3);
    const std::vector<Place>& table = kind == Kind::look_alike ? confusable() : places();
    const std::size_t count = table.size();
    const Place& place = table[static_cast<std::size_t>(index) % count];
    Plan p{kind, "", place.effect, dice.of(place.rigs), 1.0};
    static constexpr std::array<double, 3> targets{0.5, 1.0, 2.0};
    p.target = targets[(static_cast<std::size_t>(index) / count) % 3];
    if (kind == Kind::null) {
        static constexpr std::array<const char*, 4> kinds{"white", "heavy", "correlated",
                                                          "mis_set"};
        p.subkind = kinds[static_cast<std::size_t>(index % 4)];
        // Not in step with the sixteen effects.
        p.effect = table[dice.pick(count)].effect;
        for (const Place& other : table)
            if (p.effect == other.effect) p.rig = dice.of(other.rigs);
    }
    if (kind == Kind::pair) {
        p.subkind = index % 2 == 0 ? "cancelling" : "plain";
        p.target = 1.5;
    }
    return p;
}

Plan another(const Plan& first, std::uint64_t seed, int number, int round) {
    Dice dice(seed, static_cast<std::uint64_t>(number), 1000 + static_cast<std::uint64_t>(round));
    Plan p = first;
    const Place& place = dice.of(first.kind == Kind::look_alike ? confusable() : places());
    p.effect = place.effect;
    p.rig = dice.of(place.rigs);
    return p;
}

}  // namespace prove
