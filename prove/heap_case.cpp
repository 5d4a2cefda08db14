// SPDX-License-Identifier: MIT
#include "prove/heap_case.hpp"

#include "prove/case_text.hpp"
#include "prove/dice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace prove {
namespace {

std::string grain_of(const Powder& g) {
    return fmt::format(
        "{{\"diameter\": {}, \"density\": \"{:.6g} kg/m^3\", \"youngs_modulus\": \"{:.6g} kPa\", "
        "\"poisson_ratio\": {:.4g}}}",
        json_text(quantity(g.diameter, "m")), g.density, g.youngs_modulus / 1e3, g.poisson_ratio);
}

std::string conditions_of(const HeapRig& r) {
    return fmt::format(
        "{{\"base\": \"glued_grains\", \"base_diameter\": {}, \"grains\": {}, \"drop_height\": {}, "
        "\"feed_diameter\": {}, \"feed_rate\": \"{:.6g} 1/s\"}}",
        json_text(quantity(r.base_diameter, "m")), r.grains,
        json_text(quantity(r.drop_height, "m")), json_text(quantity(r.feed_diameter, "m")),
        r.feed_rate);
}

std::string csv_of(const Arrangement& a, const std::vector<double>& rows) {
    constexpr double degrees = 180.0 / 3.14159265358979323846;
    std::string text = "azimuth [deg],r [mm],z [mm]\n";
    for (std::size_t k = 0; k < rows.size(); ++k)
        text += fmt::format("{:.6g},{:.6g},{:.5g}\n", a.spots[k].azimuth * degrees,
                            a.spots[k].r * 1e3, rows[k] * 1e3);
    return text;
}

}  // namespace

// One that cancels: the fine heap's flank is as steep as the user's model says it is, and the rest shows: lambda >= 25 as of single
// grains, or the most of what was drawn.
HeapSecret heap_secret(std::uint64_t seed, const HeapPlan& given, const HeapFamily& f,
                       const std::vector<Response>& responses) {
    HeapPlan p = given;
    const Arrangement& fine = f.arrangements.front();
    const std::vector<Response> fitted(responses.begin(), responses.end() - 1);
    if (p.kind == HeapKind::cancelling) {
        const HeapEffect e = heap_effects(f)[p.effect == "adhesion" ? 0 : 1];
        Dice dice(seed, static_cast<std::uint64_t>(p.number), 23);
        const auto flank_of = [&](const std::string& effect, double strength, double friction) {
            return flank(fine, mean_features(responses.front(), effect, strength, friction, 0.0));
        };
        constexpr int draws = 200, steps = 100;
        constexpr double shows = 25.0, alike = 1e-3;
        double most = -1.0, nearest = 1e300;
        for (int k = 0; k < draws && most < shows; ++k) {
            HeapPlan q = given;
            q.start = rounded(dice.uniform(0.3, 0.85), 2);
            q.strength = rounded(dice.log_uniform(e.low, e.high), 3);
            const double wanted = flank_of("", 0.0, q.start);
            double least = 1e300;
            for (int i = 0; i <= steps; ++i) {
                const double friction =
                    rounded(f.low + 0.05 + (q.start - f.low - 0.1) * i / steps, 3);
                const double off = std::abs(flank_of(q.effect, q.strength, friction) - wanted);
                if (q.start - friction > 0.1 && off < least) least = off, q.friction = friction;
            }
            if (least < nearest && most < 0.0) nearest = least, p = q;
            if (least > alike) continue;
            const double lambda =
                heap_lambda(f, fitted, q.effect, q.strength, q.friction, q.azimuth);
            if (lambda > most) most = lambda, p = q;
        }
    }
    return {p, heap_oracle(f, fitted, p.effect, p.strength, p.friction, p.azimuth)};
}

std::vector<HeapRecording> heap_recordings(std::uint64_t seed, const HeapPlan& p,
                                           const HeapFamily& f) {
    std::vector<HeapRecording> all;
    const HeapPhysics acts = with_effect(f, p.effect, p.strength, p.friction, p.azimuth);
    for (std::size_t a = 0; a < f.arrangements.size(); ++a) {
        const bool last = a + 1 == f.arrangements.size();
        for (int k = 1; k <= (last ? 1 : repeats); ++k) {
            Dice dice(seed, static_cast<std::uint64_t>(p.number), 100 + all.size());
            const Arrangement& of = f.arrangements[a];
            all.push_back(
                {fmt::format("{}-{}", of.id, k), a, last,
                 Pour{of.grain, of.rig, acts, static_cast<std::uint64_t>(dice.uniform() * 9e15)}});
        }
    }
    return all;
}

std::vector<double> recorded(std::uint64_t seed, const HeapPlan& p, const Arrangement& a,
                             const std::vector<double>& heights, std::size_t recording) {
    Dice dice(seed, static_cast<std::uint64_t>(p.number), 200 + recording);
    std::vector<double> rows;
    const double offset = p.effect == "measurement_offset" ? p.strength : 0.0;
    const double scale = p.effect == "measurement_scale" ? 1.0 + p.strength : 1.0;
    for (const double z : heights) rows.push_back(scale * z + offset + a.noise * dice.normal());
    return rows;
}

std::map<std::string, std::string> heap_files(const HeapPlan& p, const HeapFamily& f,
                                              const std::vector<HeapRecording>& recordings,
                                              const std::vector<std::vector<double>>& rows) {
    std::map<std::string, std::string> files;
    std::string experiments;
    const Powder& common = f.arrangements.front().grain;
    for (std::size_t k = 0; k < recordings.size(); ++k) {
        const HeapRecording& r = recordings[k];
        const Arrangement& a = f.arrangements[r.arrangement];
        experiments += fmt::format(
            "{}    {{\"id\": {}, \"rig\": \"pile\", \"conditions\": {},{}\n     \"recording\": {}, "
            "\"noise\": {{\"z\": {}}}, \"role\": \"{}\"}}",
            k > 0 ? ",\n" : "", json_text(r.id), conditions_of(a.rig),
            a.grain.diameter != common.diameter ? fmt::format(" \"grain\": {},", grain_of(a.grain))
                                                : std::string(),
            json_text(r.id + ".csv"), json_text(quantity(a.noise, "m")),
            r.held_out ? "held_out" : "fit");
        files[r.id + ".csv"] = csv_of(a, rows[k]);
    }
    const bool spread = f.size_spread > 0.0;
    files["case.json"] = fmt::format(
        "{{\n  \"format\": \"similitude-case/1\",\n  \"title\": {},\n  \"grain\": {},\n"
        "  \"surroundings\": {{\"gravity\": \"9.81 m/s^2\"}},\n"
        "  \"model\": {{\"physics\": [\"gravity\", \"hertz_mindlin\"{}],\n    \"parameters\": "
        "{{\"restitution\": {{\"value\": {:.4g}}},{}\n      \"sliding_friction\": {{\"value\": "
        "{:.4g}, "
        "\"range\": [{:.4g}, {:.4g}]}}}}}},\n  \"experiments\": [\n{}\n  ]\n}}\n",
        json_text(case_name(p.number)), grain_of(common), spread ? ", \"polydispersity\"" : "",
        common.restitution,
        spread ? fmt::format(" \"size_spread\": {{\"value\": {:.4g}}},", f.size_spread) : "",
        p.start, f.low, f.high, experiments);
    return files;
}

Key heap_key(const HeapSecret& s, const HeapFamily& f, const std::vector<Response>& responses,
             const std::vector<double>& rows) {
    const HeapPlan& p = s.plan;
    Key key;
    key.name = case_name(p.number);
    key.kind = p.kind == HeapKind::null ? Kind::null : Kind::single;
    key.subkind = p.kind == HeapKind::cancelling ? "cancelling" : "plain";
    key.rig = "pile";
    if (p.kind != HeapKind::null) {
        key.effects = {p.effect}, key.channels = {acts_among_grains(p.effect) ? "" : "z"};
        const double value = p.effect == "measurement_scale" ? 1.0 + p.strength : p.strength;
        for (const HeapEffect& e : heap_effects(f))
            if (e.name == p.effect)
                key.parameters = {
                    {p.effect, key.channels.front(), e.parameter, e.unit, value, 0.0}};
    }
    key.parameters.push_back({"model", "", "sliding_friction", "1", p.friction, 0.0});
    key.lambda = p.kind == HeapKind::null ? 0.0 : s.oracle.lambda;
    key.separation.d = p.kind == HeapKind::null ? 0.0 : s.oracle.d;
    key.separation.effect = s.oracle.nearest;
    const auto [low, high] = std::minmax_element(rows.begin(), rows.end());
    key.noise_floor = 100.0 *
                      std::hypot(responses.back().spot_scatter, f.arrangements.back().noise) /
                      (*high - *low);
    return key;
}

}  // namespace prove
