// SPDX-License-Identifier: MIT
#include "app/pile_cost.hpp"

#include "app/machine_speed.hpp"
#include "cases/messages.hpp"
#include "reports/numbers.hpp"
#include "scaling/cost.hpp"
#include "scaling/errors.hpp"

#include <fmt/format.h>

namespace app {

namespace {

using cases::Experiment;
using scaling::InvalidInput;
using scaling::mistake;

constexpr double most_grains_unasked = 5e6;  // some 5 GB of grains and contacts

// Feeding until grains fall off needs a count here; says how many the base is likely to carry.
void refuse_endless(const Experiment& e) {
    const cases::Value& grains = e.conditions.at("grains");
    if (grains.kind != cases::Value::Kind::text) return;
    constexpr double angle = 0.7853981633974483,
                     packing = 0.5;  // 45 degrees: an order of magnitude is meant
    const double likely = scaling::grains_in(
        {e.conditions.at("base_diameter").quantity<scaling::Length>(), angle, packing},
        e.grain.diameter.value);
    cases::refuse(
        grains, "must be a count to be simulated",
        fmt::format("a heap on this base holds about {} grains of {}; scale the powder first",
                    reports::number(likely),
                    reports::quantity(e.grain.diameter.value.value(), "m")));
}

[[noreturn]] void refuse_cost(const Experiment& e, const std::string& got,
                              const std::string& rule) {
    throw InvalidInput(
        mistake("experiment " + cases::in_quotes(e.id), got, rule,
                "take fewer or larger grains (similitude scale), a softer modulus, or say --yes"));
}

}  // namespace

rigs::PileSetup counted_setup(const cases::Case& c, const Experiment& e, std::uint64_t seed,
                              bool yes) {
    refuse_endless(e);
    const double grains = static_cast<double>(e.conditions.at("grains").count());
    if (!yes && grains > most_grains_unasked)
        refuse_cost(e, reports::count(grains) + " grains", "must not be more than 5e6 unasked");
    return rigs::pile_setup(c, e, seed);
}

static double seconds_of(std::size_t grains, std::int64_t steps, int threads) {
    return static_cast<double>(grains) * static_cast<double>(steps) / measured_speed(threads);
}

double seconds_of(const rigs::PileSetup& setup, int threads) {
    return seconds_of(setup.feed_time.size() * rigs::spheres_per_grain(setup),
                      rigs::expected_steps(setup), threads);
}

void refuse_unaffordable(const Experiment& e, std::size_t grains, std::int64_t steps, int threads) {
    const double seconds = seconds_of(grains, steps, threads);
    if (seconds <= longest_unasked) return;
    refuse_cost(
        e,
        fmt::format("{} grains x {} steps, about {} on this machine",
                    reports::count(static_cast<double>(grains)),
                    reports::count(static_cast<double>(steps)), reports::quantity(seconds, "s")),
        "must not need more than 12 h unasked");
}

void refuse_unaffordable(const Experiment& e, const rigs::PileSetup& setup, int threads) {
    refuse_unaffordable(e, setup.feed_time.size() * rigs::spheres_per_grain(setup),
                        rigs::expected_steps(setup), threads);
}

}  // namespace app
