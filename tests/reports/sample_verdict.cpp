// SPDX-License-Identifier: MIT
#include "sample_verdict.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

using namespace diagnose;

namespace {

PredictedCurve empty_curve(std::string id, bool held_out, std::string channel, std::string unit,
                           std::string ordinate, std::string ordinate_unit) {
    return {.experiment = std::move(id),
            .channel = std::move(channel),
            .unit = std::move(unit),
            .held_out = held_out,
            .ordinate = std::move(ordinate),
            .ordinate_unit = std::move(ordinate_unit),
            .at = {},
            .branch = {},
            .recorded = {},
            .base = {},
            .extended = {},
            .noise = 2e-3};
}

// Free fall, and the same with half a percent of it missing for each hundredth of a second.
PredictedCurve fall(const std::string& id, bool held_out, double height) {
    PredictedCurve c = empty_curve(id, held_out, "z", "m", "t", "s");
    for (int k = 0; k < 12; ++k) {
        const double t = 0.025 * k, drop = 4.905 * t * t;
        c.at.push_back(t);
        c.base.push_back(height - drop);
        c.extended.push_back(height - drop * (1.0 - 0.05 * t / 0.1));
        c.recorded.push_back(c.extended.back() + (k % 2 == 0 ? 1e-3 : -1e-3));
    }
    c.recorded[5] = std::numeric_limits<double>::quiet_NaN();  // nothing was measured
    return c;
}

PredictedCurve force_curve() {
    PredictedCurve c = empty_curve("curve-1", false, "force", "N", "separation", "m");
    c.noise = 1e-9;
    for (int k = 0; k < 12; ++k) {
        const bool back = k >= 6;
        c.at.push_back(5e-9 * (back ? k - 5 : 6 - k));
        c.branch.emplace_back(back ? "retract" : "approach");
        c.base.push_back(0.0);
        c.extended.push_back(-1e-8 * std::pow(5e-9 / c.at.back(), 2));
        c.recorded.push_back(c.extended.back());
    }
    return c;
}

}  // namespace

Verdict air_drag_verdict() {
    Verdict v{};
    v.title = "a bead that falls";
    v.seed = 7;
    v.answer = Answer::explained;
    v.p_value = 1e-4;
    v.located = {{"drop-1", "z", "t", "s", 0.15, 0.275, 1, 0.031, "m", 1e-4},
                 {"drop-2", "z", "speed", "m/s", 2.1, 4.8, 1, 0.044, "m", 1e-4}};
    v.hypotheses = {
        {{"air_drag"}, 0.96}, {{"air_drag", "tilt"}, 0.03}, {{"unknown"}, 0.01}, {{}, 0.0}};
    v.effects = {{.name = "air_drag",
                  .probability = 0.99,
                  .named = true,
                  .parameters = {{"drag_coefficient", "1", 0.47, 0.44, 0.5}},
                  .gates = {{"range", GateResult::passed, "0.47 lies inside 0.1 to 2."},
                            {"placebo", GateResult::passed, "No placebo does as well."},
                            {"scaling", GateResult::untestable, "One diameter was recorded."}},
                  .why = {"It slows the grain the more the faster it moves."},
                  .missing = std::nullopt},
                 {.name = "tilt",
                  .probability = 0.06,
                  .named = false,
                  .parameters = {{"tilt_angle", "rad", 0.01, -0.02, 0.04}},
                  .gates = {{"placebo", GateResult::failed, "A placebo does better."}},
                  .why = {},
                  .missing = std::nullopt}};
    v.fit = {1.9, 0.31, 0.29, {}};
    v.held_out = {2.6, 0.14, 0.13, {"drop-2"}};
    v.refitted = {{"restitution", "1", 0.61, 0.6, 0.62}};
    v.next_experiment = {.rig = "drop",
                         .conditions = {{"height", "2 m"}},
                         .grain = {{"density", "28 kg/m^3"}},
                         .channels = {"z"},
                         .ordinate = "t",
                         .ordinate_unit = "s",
                         .from = 0.0,
                         .to = 0.6,
                         .rows = 200,
                         .noise = {{"z", 1.5e-3}},
                         .between = {"air_drag", "air_drag + tilt"},
                         .separation_sigma = 8.2,
                         .why = "A light grain falls long enough for the two to part."};
    v.warnings = {"air drag: gate \"scaling\" cannot be tested."};
    v.summary = {"After refitting, the model differs from the recordings <by more than noise>.",
                 "What was left out: air drag."};
    v.flips = {"A recording that speaks for a leaning plate."};
    v.curves = {fall("drop-1", false, 0.6), fall("drop-2", true, 1.2)};
    v.noise_correlation = 0.2;
    return v;
}

Verdict unknown_verdict() {
    Verdict v{};
    v.title = "a curve";
    v.seed = 1;
    v.answer = Answer::unexplained;
    v.p_value = 0.002;
    v.located = {{"curve-1", "force", "separation", "m", 5e-9, 1.5e-8, -1, 6e-9, "N", 0.002}};
    v.hypotheses = {{{"unknown"}, 0.9}, {{"adhesion"}, 0.1}};
    v.effects = {{.name = "unknown",
                  .probability = 0.9,
                  .named = false,
                  .parameters = {},
                  .gates = {},
                  .why = {},
                  .missing = MissingEstimate{"separation",
                                             "m",
                                             {5e-9, 1e-8, 3e-8},
                                             {-1e-8, -2.5e-9, 0.0},
                                             {-1.2e-8, -3e-9, -1e-9},
                                             {-8e-9, -2e-9, 1e-9},
                                             "an attraction to the plate"}}};
    v.fit = {12.0, 2.0, 2.0, {}};
    v.summary = {"Nothing in the catalogue explains it."};
    v.curves = {force_curve()};
    return v;
}

Verdict undecided_verdict() {
    const double none = std::numeric_limits<double>::quiet_NaN();
    Verdict v{};
    v.title = "two rows";
    v.seed = 1;
    v.answer = Answer::undecided;
    v.p_value = none;
    v.effects = {{.name = "tilt",
                  .probability = none,
                  .named = false,
                  .parameters = {{"tilt_angle", "rad", none, none, 0.1}},
                  .gates = {},
                  .why = {},
                  .missing = std::nullopt}};
    v.fit = {none, none, 0.1, {}};
    v.warnings = {"Two rows are too few."};
    v.noise_correlation = none;
    return v;
}
