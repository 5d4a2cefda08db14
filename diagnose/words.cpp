// SPDX-License-Identifier: MIT
#include "diagnose/words.hpp"

#include "cases/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace diagnose {
namespace {

const std::map<std::string, const char*>& signatures() {
    static const std::map<std::string, const char*> table{
        {"air_drag", "It slows the grain the more the faster it moves, and light grains most."},
        {"buoyancy", "It takes a fixed part of the weight, moving or not."},
        {"adhesion", "It holds the contact while it is pulled, and stops slow rebounds."},
        {"van_der_waals", "It pulls before the surfaces touch, as the inverse square of the gap."},
        {"capillary_bridge",
         "It pulls once the grain has touched, out to the rupture of the bridge."},
        {"electrostatic", "It pulls at any distance up to a radius or so, coming and going."},
        {"rolling_resistance", "It brakes a rolling grain by the same amount at any speed."},
        {"viscoelastic_restitution",
         "The faster the impact, the less of it comes back: 1 - e grows as v^(1/5)."},
        {"plastic_restitution", "Above a yield velocity the restitution falls as v^(-1/4)."},
        {"velocity_dependent_friction", "Friction is another one when the surfaces slip fast."},
        {"tangential_compliance",
         "The contact gives way sideways before it slips: seen at steep impacts alone."},
        {"polydispersity", "Grains of many sizes: the surface is rougher, and the heap larger."},
        {"wall_friction", "The base holds the lowest layer by another friction than the grains'."},
        {"wall_adhesion", "The base holds the lowest layer by more than weight and friction."},
        {"tilt", "The plate leans: the grain is driven sideways all the time."},
        {"vibration", "The plate moves: every impact gives or takes a little, in time with it."},
        {"measurement_scale",
         "All recorded values are too large or too small by one factor: an instrument, no "
         "physics."},
        {"measurement_offset",
         "All recorded values are off by one amount: an instrument, no physics."},
        {"time_base", "The clock of the recording runs fast or slow: an instrument, no physics."},
        {"numerical_artefact",
         "It goes when the simulation is refined: the step or the softened modulus, no physics."}};
    return table;
}

// Least-squares exponent of |values| against |x - x0| over the half of the range where it is large; NaN where that says nothing.
double exponent(const MissingEstimate& m) {
    double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0, n = 0.0;
    for (std::size_t k = 0; k < m.knots.size(); ++k) {
        const bool sure = m.low[k] * m.high[k] > 0.0;
        if (!sure || m.knots[k] <= 0.0) continue;
        const double x = std::log(m.knots[k]), y = std::log(std::abs(m.values[k]));
        sx += x, sy += y, sxx += x * x, sxy += x * y, n += 1.0;
    }
    const double spread = sxx - sx * sx / std::max(n, 1.0);
    return n >= 3.0 && spread > 1e-9 ? (sxy - sx * sy / n) / spread : std::nan("");
}

// To three digits: more are not known.
std::string told(double value, const std::string& unit) {
    return cases::format_si(std::stod(fmt::format("{:.3g}", value)), unit);
}

std::string joined(const std::vector<std::string>& effects) {
    std::string text;
    for (const std::string& e : effects) text += (text.empty() ? "" : " and ") + plain_name(e);
    return text.empty() ? "nothing left out" : text;
}

}  // namespace

std::string plain_name(const std::string& effect) {
    if (effect == "none") return "nothing left out";
    if (effect == "unknown") return "something that is not in the catalogue";
    std::string text = effect;
    std::replace(text.begin(), text.end(), '_', ' ');
    return text;
}

std::vector<std::string> reasons(const std::string& effect, double probability, double gain,
                                 const std::vector<Located>& where) {
    std::vector<std::string> list;
    const auto known = signatures().find(effect);
    if (known != signatures().end()) list.emplace_back(known->second);
    if (gain > 0.0)
        list.push_back(fmt::format(
            "With it the misfit (chi squared) falls by {:.0f}; its probability is {:.2f}.", gain,
            probability));
    if (!where.empty())
        list.push_back(fmt::format("The mismatch is seen in {} of {}, at {} from {} to {}.",
                                   where.front().channel, where.front().experiment,
                                   where.front().variable,
                                   cases::format_si(where.front().from, where.front().unit),
                                   cases::format_si(where.front().to, where.front().unit)));
    return list;
}

std::string described(const MissingEstimate& m) {
    std::size_t strongest = 0;
    for (std::size_t k = 0; k < m.values.size(); ++k)
        if (std::abs(m.values[k]) > std::abs(m.values[strongest])) strongest = k;
    const bool sure = m.low[strongest] * m.high[strongest] > 0.0;
    const double f = m.values[strongest];
    if (m.of == Missing::drift)
        return fmt::format("a reading of {} that is {} too {} after {}{}", m.channel,
                           told(std::abs(f), m.unit_of_values), f < 0.0 ? "low" : "high",
                           told(m.knots[strongest], m.unit), sure ? "" : " (not sure to 90 %)");
    if (m.of == Missing::restitution)
        return fmt::format("a rebound {} by {:.2g} % at an {} of {}{}",
                           f < 0.0 ? "slower" : "faster", 100.0 * std::abs(f),
                           plain_name(m.variable), told(m.knots[strongest], m.unit),
                           sure ? "" : " (not sure to 90 %)");
    const std::string sort =
        m.variable == "z" || m.variable == "separation"
            ? (f < 0.0 ? "an attraction to the plate" : "a repulsion from the plate")
            : (f < 0.0 ? "a force against the positive direction"
                       : "a force along the positive direction");
    std::string text =
        fmt::format("{} of {} at {} = {}{}", sort, told(std::abs(f), "N"), m.variable,
                    told(m.knots[strongest], m.unit), sure ? "" : " (not sure to 90 %)");
    const double power = exponent(m);
    const double flat = *std::min_element(m.values.begin(), m.values.end()) *
                        *std::max_element(m.values.begin(), m.values.end());
    if (flat > 0.0 && std::isfinite(power) && std::abs(power) < 0.3)
        text += ", about the same everywhere";
    else if (std::isfinite(power))
        text += fmt::format(", going as {} to the power {:.1f}", m.variable, power);
    return text;
}

std::vector<std::string> summary_of(const Verdict& v) {
    std::vector<std::string> list;
    const std::string chance =
        v.p_value < 0.001 ? "less than 1 in 1000" : fmt::format("{:.2g}", v.p_value);
    if (v.answer == Answer::undecided) {
        list.emplace_back("These recordings cannot show whether physics was left out.");
    } else if (v.answer == Answer::consistent) {
        list.push_back(
            fmt::format("The model fits the recordings as well as their noise allows: a mismatch "
                        "as large as this comes by chance with probability {}.",
                        chance));
    } else {
        list.push_back(
            fmt::format("After refitting, the model differs from the recordings by more than noise "
                        "(probability by chance: {}).",
                        chance));
    }
    std::vector<std::string> named;
    for (const Effect& e : v.effects)
        if (e.named) named.push_back(e.name);
    if (v.answer == Answer::explained)
        list.push_back(fmt::format("What was left out: {}.", joined(named)));
    if (v.answer == Answer::ambiguous && v.alike.size() > 1) {
        std::string others;
        for (std::size_t k = 1; k < v.alike.size(); ++k)
            others += (k > 1 ? " or " : "") + joined(v.alike[k]);
        list.push_back(
            fmt::format("These recordings cannot tell {} from {}.", joined(v.alike[0]), others));
    }
    if (v.answer == Answer::unexplained) {
        list.emplace_back("Nothing in the catalogue, nor any pair of effects, explains it.");
        for (const Effect& e : v.effects)
            if (e.missing)
                list.push_back(fmt::format("As far as the data show, it is {}.", e.missing->words));
    }
    if (v.held_out && v.answer == Answer::explained)
        list.push_back(fmt::format(
            "On recordings that took no part in any fit the error falls from {:.2g} % to {:.2g} % "
            "of their range; noise alone makes {:.2g} %.",
            v.held_out->nrmse_base, v.held_out->nrmse_extended, v.held_out->noise_floor));
    if (v.next_experiment)
        list.push_back(fmt::format("To decide, record a run of the rig {}. {}",
                                   v.next_experiment->rig, v.next_experiment->why));
    return list;
}

std::vector<std::string> flips_of(const Verdict& v) {
    std::vector<std::string> list;
    if (v.answer == Answer::consistent)
        list.push_back(fmt::format("Less noise or more recordings: p is {:.2g}, 0.05 is the limit.",
                                   v.p_value));
    if (v.answer != Answer::consistent && v.answer != Answer::undecided && v.p_value > 0.005)
        list.push_back(fmt::format("A little more noise than assumed: p is {:.2g}.", v.p_value));
    if (v.hypotheses.size() > 1 && v.answer != Answer::consistent &&
        v.answer != Answer::undecided && v.hypotheses[1].probability > 0.001)
        list.push_back(fmt::format("A recording that speaks for {} (probability now {:.2g}).",
                                   joined(v.hypotheses[1].effects), v.hypotheses[1].probability));
    for (const Effect& e : v.effects)
        for (const Gate& g : e.gates)
            if (e.named && g.result == GateResult::untestable)
                list.push_back(fmt::format(
                    "A recording in which the gate \"{}\" of {} can be tested, and fails.", g.name,
                    plain_name(e.name)));
    return list;
}

}  // namespace diagnose
