// SPDX-License-Identifier: MIT
#include "reports/diagnosis.hpp"

#include "reports/diagnosis_figures.hpp"
#include "reports/diagnosis_json.hpp"
#include "reports/page.hpp"
#include "sample_verdict.hpp"
#include "samples.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

using namespace reports;

namespace {

const Provenance who{.version = "1.2.3",
                     .git = "abc",
                     .compiler = "GNU",
                     .command = "similitude diagnose drops",
                     .case_path = "drops/case.json",
                     .seeds = {7},
                     .threads = 2};

std::vector<std::string> keys(const Json& object) {
    std::vector<std::string> names;
    for (const auto& [name, value] : object.items()) names.push_back(name);
    return names;
}

std::string page_of(const diagnose::Verdict& v) {
    Page page{.title = v.title,
              .verdict = verdict_of(v),
              .diagnosis = v,
              .limits = limits_of(v),
              .provenance = who};
    return html(page);
}

}  // namespace

TEST_CASE("verdict as JSON: the keys of similitude-verdict/1 in their order, extras behind them",
          "[reports][diagnosis]") {
    const Json json = to_json(air_drag_verdict(), who);
    CHECK(keys(json) == std::vector<std::string>{
                            "format", "case", "tool", "verdict", "located", "hypotheses", "effects",
                            "fit", "held_out", "refitted", "next_experiment", "warnings", "title",
                            "p_value", "summary", "would_change", "noise_correlation"});
    CHECK(json["format"] == "similitude-verdict/1");
    CHECK(json["case"] == "drops/case.json");
    CHECK(json["tool"]["version"] == "1.2.3");
    CHECK(json["tool"]["git"] == "abc");
    CHECK(json["tool"]["seed"] == 7);
    CHECK(json["verdict"] == "explained");
    CHECK(keys(json["located"][0]) == std::vector<std::string>{"experiment", "channel", "variable",
                                                               "from", "to", "sign", "size",
                                                               "p_value"});
    CHECK(keys(json["effects"][0]) == std::vector<std::string>{"name", "probability", "named",
                                                               "parameters", "gates", "why",
                                                               "gates_why"});
    CHECK(keys(json["fit"]) ==
          std::vector<std::string>{"nrmse_base", "nrmse_extended", "noise_floor"});
    CHECK(json["held_out"]["experiments"] == Json({"drop-2"}));
    CHECK(json["next_experiment"]["conditions"]["height"] == "2 m");
    CHECK(json["next_experiment"]["noise"]["z"] == "1.5 mm");
}

TEST_CASE("verdict as JSON: a place carries its unit, a parameter has it beside it",
          "[reports][diagnosis]") {
    const Json json = to_json(air_drag_verdict(), who);
    const Json& speed = json["located"][1];
    CHECK(speed["from"] == "2.1 m/s");
    CHECK(speed["to"] == "4.8 m/s");
    CHECK(speed["size"] == "44 mm");
    CHECK(speed["sign"] == "+");
    const Json& drag = json["effects"][0]["parameters"]["drag_coefficient"];
    CHECK(drag["value"] == 0.47);
    CHECK(drag["ci90"] == Json({0.44, 0.5}));
    CHECK(drag["unit"] == "1");
    CHECK(json["effects"][0]["gates"]["scaling"] == "untestable");
    const Json curve = to_json(unknown_verdict(), who);
    CHECK(curve["located"][0]["from"] == "5 nm");
    CHECK(curve["located"][0]["sign"] == "-");
}

TEST_CASE("verdict as JSON: probabilities of hypotheses sum to 1 as printed",
          "[reports][diagnosis]") {
    diagnose::Verdict v = air_drag_verdict();
    v.hypotheses.clear();
    // 3/7 and 12/21: sevenths and 21sts have no end as decimals.
    for (int k = 0; k < 3; ++k) v.hypotheses.push_back({{"tilt"}, 1.0 / 7.0});
    for (int k = 0; k < 12; ++k) v.hypotheses.push_back({{"air_drag"}, 4.0 / 84.0});
    long long millionths = 0;
    const Json json = to_json(v, who);
    for (const Json& h : json["hypotheses"]) {
        const std::string printed = h["probability"].dump();
        REQUIRE(printed.size() <= 8);  // "0.142857"
        millionths += std::llround(std::strtod(printed.c_str(), nullptr) * 1e6);
    }
    CHECK(millionths == 1000000);
}

TEST_CASE("verdict as JSON: what is not known is null and says why", "[reports][diagnosis]") {
    const std::string text = text_of(to_json(undecided_verdict(), who));
    CHECK(times_in(text, "nan") == 0);
    const Json json = Json::parse(text);
    CHECK(json["p_value"].is_null());
    CHECK(json["reasons"]["p_value"].is_string());
    CHECK(json["reasons"]["noise_correlation"].is_string());
    CHECK(json["held_out"].is_null());
    CHECK(json["reasons"]["held_out"].is_string());
    CHECK(json["next_experiment"].is_null());
    CHECK(json["fit"]["nrmse_base"].is_null());
    CHECK(json["fit"]["reasons"]["nrmse_base"].is_string());
    const Json& tilt = json["effects"][0];
    CHECK(tilt["reasons"]["probability"].is_string());
    CHECK(tilt["parameters"]["tilt_angle"]["reasons"]["ci90"].is_string());
    CHECK(tilt["parameters"]["tilt_angle"]["ci90"][1] == 0.1);
}

TEST_CASE("verdict as JSON: a missing force is a function of the state", "[reports][diagnosis]") {
    const Json json = to_json(unknown_verdict(), who);
    const Json& force = json["effects"][0]["parameters"]["force"];
    CHECK(force["variable"] == "separation");
    CHECK(force["at"].size() == 3);
    CHECK(force["value"].size() == 3);
    CHECK(force["ci90"][1] == Json({-3e-9, -2e-9}));
    CHECK(force["unit"] == "N");
}

TEST_CASE("verdict in words: consistent is yes, a mismatch no, the rest cannot tell",
          "[reports][diagnosis]") {
    using diagnose::Answer;
    CHECK(answer_of(Answer::consistent) == reports::Answer::yes);
    CHECK(answer_of(Answer::explained) == reports::Answer::no);
    CHECK(answer_of(Answer::unexplained) == reports::Answer::no);
    CHECK(answer_of(Answer::ambiguous) == reports::Answer::cannot_tell);
    CHECK(answer_of(Answer::undecided) == reports::Answer::cannot_tell);
}

TEST_CASE("verdict in words: what is no physics is not called left out", "[reports][diagnosis]") {
    diagnose::Verdict v = air_drag_verdict();
    CHECK(verdict_of(v).headline == "Explained: air drag was left out");
    v.effects[1].named = true;
    CHECK(verdict_of(v).headline == "Explained: air drag and tilt were left out");
    v.effects[1].name = "measurement_offset";
    CHECK(verdict_of(v).headline ==
          "Explained: air drag was left out, and measurement offset stands beside it");
    v.effects[0].named = false;
    CHECK(verdict_of(v).headline == "Explained without physics left out: measurement offset");
}

TEST_CASE("verdict in words: a terminal gets place, probability, parameter and what next",
          "[reports][diagnosis]") {
    const std::string text = text_of(air_drag_verdict());
    for (const char* part :
         {"Explained: air drag was left out.",
          "drop-2, z: recorded lies above simulated by 44 mm (rms) for speed from 2.1 m/s to 4.8",
          "0.960  air drag\n", "drag coefficient", "0.44 to 0.5", "held out", "2.6", "0.14",
          "tilt fails the gate placebo", "8.2 sigma", "Warnings"}) {
        INFO(text);
        INFO(part);
        CHECK(text.find(part) != std::string::npos);
    }
    CHECK(text_of(undecided_verdict()).find("nan") == std::string::npos);
}

TEST_CASE("verdict as a page: well-formed, in the order of reading, no text becomes markup",
          "[reports][diagnosis]") {
    const std::string text = page_of(air_drag_verdict());
    CHECK(fault_in_markup(text) == "");
    CHECK(times_in(text, "<by more than noise>") == 0);
    CHECK(times_in(text, "class=\"verdict no\"") == 1);
    std::size_t before = 0;
    for (const char* part : {"Explained: air drag was left out", "id=\"where\"", "drop-1, z",
                             "drop-2, z (held out)", "id=\"hypotheses\"", "id=\"effects\"",
                             "id=\"numbers\"", "id=\"next\"", "Warnings", "id=\"limits\""}) {
        INFO(part);
        const std::size_t at = text.find(part, before);
        REQUIRE(at != std::string::npos);
        before = at;
    }
    CHECK(times_in(text, "\u2713 passed") == 2);
    CHECK(times_in(text, "\u2717 failed") == 1);
    CHECK(times_in(text, "? untestable") == 1);
    for (const diagnose::Verdict& v : {unknown_verdict(), undecided_verdict()}) {
        const std::string other = page_of(v);
        CHECK(fault_in_markup(other) == "");
        CHECK(times_in(other, ">nan") == 0);
    }
    CHECK(times_in(page_of(undecided_verdict()), "No test was made.") == 1);
}

TEST_CASE("figures: a located interval is marked over its own ordinate, else said in words",
          "[reports][diagnosis]") {
    const std::vector<CurveFigures> figures = curve_figures(air_drag_verdict());
    REQUIRE(figures.size() == 2);
    CHECK(times_in(figures[0].curve.svg, "where they differ") == 1);
    CHECK(times_in(figures[1].curve.svg, "where they differ") == 0);
    CHECK(figures[1].residual.caption.find("for speed from 2.1 m/s to 4.8 m/s") !=
          std::string::npos);
    CHECK(times_in(figures[0].curve.svg, "NaN") + times_in(figures[0].curve.svg, "nan") == 0);
}

TEST_CASE("figures: each branch of a force curve has its own", "[reports][diagnosis]") {
    const std::vector<CurveFigures> figures = curve_figures(unknown_verdict());
    REQUIRE(figures.size() == 2);
    CHECK(figures[0].name == "curve-1, force, approach");
    CHECK(figures[1].name == "curve-1, force, retract");
    CHECK(times_in(figures[0].curve.svg, "separation, nm") == 1);
    CHECK(times_in(figures[0].curve.svg, "force, nN") == 1);
}

TEST_CASE("figures: where nothing was added, one simulated line is drawn", "[reports][diagnosis]") {
    diagnose::Verdict v = air_drag_verdict();
    for (diagnose::PredictedCurve& c : v.curves) c.extended = c.base;
    CHECK(times_in(curve_figures(v)[0].curve.svg, "simulated after") == 0);
    CHECK(times_in(curve_figures(v)[0].curve.svg, "simulated, refitted") == 1);
}
