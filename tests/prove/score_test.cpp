// SPDX-License-Identifier: MIT
#include "prove/score.hpp"

#include "prove/baselines.hpp"
#include "prove/score_parts.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>

using namespace prove;

namespace {

Key key(const std::string& name, Kind kind, std::vector<std::string> effects, double d,
        double lambda) {
    Key k;
    k.name = name, k.kind = kind, k.effects = std::move(effects);
    k.subkind = kind == Kind::null ? "white" : "";
    k.separation.d = d, k.lambda = lambda, k.oracle_power = kind == Kind::null ? 0.05 : 1.0;
    k.pair_separation = d;
    return k;
}

Verdict named(const std::string& effect, double probability) {
    return {.verdict = "explained",
            .hypotheses = {{{effect}, probability}, {{}, 1.0 - probability}},
            .effects = {{.name = effect, .probability = probability, .named = true}}};
}

const Line& line(const ScoreTable& t, const std::string& figure) {
    for (const Line& l : t.lines)
        if (l.figure == figure) return l;
    throw std::runtime_error("no line " + figure);
}

}  // namespace

TEST_CASE("prove: Wilson's intervals are those of Newcombe's table", "[prove]") {
    // Newcombe (1998), Stat. Med. 17, 857, table I, method 3: four digits are printed.
    struct Row {
        int hits, count;
        double low, high;
    };
    for (const Row& r : {Row{81, 263, 0.2553, 0.3662}, Row{15, 148, 0.0624, 0.1605},
                         Row{0, 20, 0.0, 0.1611}, Row{1, 29, 0.0061, 0.1718}}) {
        const Wilson w = wilson(r.hits, r.count);
        REQUIRE(w.low == Approx(r.low).margin(5e-5));
        REQUIRE(w.high == Approx(r.high).margin(5e-5));
    }
}

TEST_CASE("prove: the score counts what is right, wrong and missing", "[prove]") {
    Keys keys;
    keys["a"] = key("a", Kind::null, {}, 0, 0);
    keys["b"] = key("b", Kind::null, {}, 0, 0);
    keys["c"] = key("c", Kind::single, {"air_drag"}, 8, 100);
    keys["d"] = key("d", Kind::single, {"tilt"}, 8, 100);
    keys["e"] = key("e", Kind::look_alike, {"adhesion"}, 1, 100);
    keys["f"] = key("f", Kind::outside, {"unknown"}, 9, 100);
    keys["g"] = key("g", Kind::single, {"air_drag"}, 8, 100);
    Judgements j;
    j.first["a"] = {.verdict = "consistent", .hypotheses = {{{}, 1.0}}};
    j.first["b"] = named("tilt", 0.9);
    j.first["c"] = named("air_drag", 0.9);
    j.first["d"] = named("time_base", 0.8);
    j.first["e"] = {.verdict = "ambiguous",
                    .hypotheses = {{{"adhesion"}, 0.5}, {{"capillary_bridge"}, 0.5}}};
    j.first["f"] = {.verdict = "unexplained", .hypotheses = {{{"unknown"}, 1.0}}};
    const ScoreTable t = score(keys, j);
    REQUIRE(t.missing == 1);
    REQUIRE(t.wrong_names == 2);
    REQUIRE(line(t, "false alarm on nulls at nominal 5 %").value == 0.5);
    REQUIRE(line(t, "a name given on a null").value == 0.5);
    REQUIRE(line(t, "right name where D >= 5").value == Approx(1.0 / 3.0));
    REQUIRE(line(t, "right name where D >= 5").count == 3);
    REQUIRE(line(t, "  least recall of an effect, D >= 5").value == 0.0);
    REQUIRE(line(t, "  most frequent wrong pair, D >= 5").note == "tilt called time_base");
    REQUIRE(line(t, "ambiguous with the truth in it, D < 3").value == 1.0);
    REQUIRE(line(t, "outside the catalogue: unknown").value == 1.0);
    // c, d, e of c, d, e, g were called a mismatch.
    REQUIRE(line(t, "power over the oracle's, lambda >= 25").value == 0.75);
    REQUIRE(t.confusion.at("air_drag").at("missing") == 1);
    REQUIRE(text(t).find("NOT met") != std::string::npos);
}

TEST_CASE("prove: Brier score and calibration of two verdicts by hand", "[prove]") {
    Keys keys;
    keys["a"] = key("a", Kind::single, {"tilt"}, 8, 100);
    keys["b"] = key("b", Kind::single, {"tilt"}, 8, 100);
    Verdicts v{{"a", named("tilt", 0.9)}, {"b", named("air_drag", 0.6)}};
    const Calibration c = calibration(keys, v);
    // a: 0.1^2 + 0.1^2; b: 0.6^2 + 0.4^2 and the truth unlisted.
    REQUIRE(c.brier == Approx(0.5 * (0.02 + 0.52 + 1.0)));
    // 0.9 and it is so, 0.1 and not, 0.6 and not, 0.4 and not, 0 and it is so.
    REQUIRE(c.expected_error == Approx((0.1 + 0.9 + 0.6 + 0.4) / 5.0));
    REQUIRE(c.expected_error_top == Approx((0.1 + 0.6) / 2.0));
}

TEST_CASE("prove: overlap over union of intervals", "[prove]") {
    REQUIRE(score_parts::overlap_over_union(0.0, 2.0, 1.0, 3.0) == Approx(1.0 / 3.0));
    REQUIRE(score_parts::overlap_over_union(2.0, 0.0, 0.0, 2.0) == 1.0);
    REQUIRE(score_parts::overlap_over_union(0.0, 1.0, 2.0, 3.0) == 0.0);
}

TEST_CASE("prove: a verdict file is read with its units, a broken one is no verdict", "[prove]") {
    namespace fs = std::filesystem;
    const fs::path dir = fs::temp_directory_path() / "similitude-prove-verdicts";
    fs::remove_all(dir);
    fs::create_directories(dir);
    std::ofstream(dir / "case-0001.json")
        << R"({"format": "similitude-verdict/1", "case": "case-0001",
      "verdict": "explained", "located": [{"experiment": "run-1", "channel": "s", "variable": "t",
      "from": "100 ms", "to": "0.3 s", "sign": "+", "p_value": 1e-4}],
      "hypotheses": [{"effects": ["tilt"], "probability": 0.9}, {"effects": [], "probability": 0.1}],
      "effects": [{"name": "tilt", "probability": 0.9, "named": true, "parameters":
        {"tilt_angle": {"value": 2.0, "ci90": [1.0, 3.0], "unit": "deg"}}}],
      "held_out": {"nrmse_extended": 1.4}, "next_experiment": null})";
    std::ofstream(dir / "case-0002.json") << R"({"format": "similitude-verdict/1", "ver)";
    const Verdicts v = read_verdicts(dir.string());
    REQUIRE(v.size() == 1);
    const Verdict& one = v.at("case-0001");
    REQUIRE(one.located[0].from == Approx(0.1));
    REQUIRE(one.effects[0].parameters[0].high == Approx(3.0 * 3.14159265358979 / 180.0));
    REQUIRE(one.named() == std::vector<std::string>{"tilt"});
    REQUIRE(*one.held_out_extended == 1.4);
    fs::remove_all(dir);
}

TEST_CASE("prove: the commonest effect is named whatever was recorded", "[prove]") {
    Keys keys;
    keys["a"] = key("a", Kind::single, {"tilt"}, 8, 100);
    keys["b"] = key("b", Kind::single, {"tilt"}, 8, 100);
    keys["c"] = key("c", Kind::null, {}, 0, 0);
    REQUIRE(commonest_verdict(keys).named() == std::vector<std::string>{"tilt"});
}
