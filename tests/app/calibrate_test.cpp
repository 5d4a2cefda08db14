// SPDX-License-Identifier: MIT
#include "command_line.hpp"

#include <catch2/catch.hpp>

using Catch::Contains;

TEST_CASE("calibrate --replay: every printed number, the rank and the null vector as JSON",
          "[app][calibrate]") {
    const Folder f;
    const Outcome o = similitude({"calibrate", "data/zirconia/case.json", "--replay", "--json", "-",
                                  "--report", f / "page.html"});
    INFO(o.err);
    REQUIRE(o.code == 3);
    const auto json = o.json();
    CHECK(json.at("format") == "similitude-replay/1");
    const auto& replay = json.at("replay");
    CHECK(replay.at("compared") == replay.at("digits").size());
    REQUIRE(replay.at("mismatches").size() == 1);
    CHECK(replay.at("mismatches")[0].at("printed") == "7.78e-7 s");
    const auto& audit = json.at("audit");
    CHECK(audit.at("rank") == 7);
    CHECK(audit.at("terms") == 8);
    CHECK(audit.at("null_vectors") == nlohmann::ordered_json{"1 - B + D - E + F + G = 0"});
    bool found = false;
    for (const auto& finding : audit.at("findings"))
        if (finding.at("name") == "rank_without_failed_runs")
            found = finding.at("text").get<std::string>().find("rank 7 of 8") == 0;
    CHECK(found);
    CHECK(audit.at("failed_runs").at("censored").at("effects").size() == 7);
    const std::string page = contents(f / "page.html");
    for (const char* part : {"calibration-effects", "calibration-imputed", "calibration-response",
                             "1 - B + D - E + F + G = 0", "Aliases"})
        CHECK_THAT(page, Contains(part));
}

namespace {

// A case of small heaps whose friction is free, and its recording, in a folder.
std::string small_calibration(const Folder& f) {
    f.write("angles.csv", "angle_of_repose [deg],estimator\n29,two_h_over_d\n31,two_h_over_d\n");
    return f.write("case.json", R"({
  "format": "similitude-case/1",
  "title": "beads on a small plate",
  "grain": {"diameter": "4 mm", "density": "1200 kg/m^3", "youngs_modulus": "2 MPa", "poisson_ratio": 0.3},
  "plate": {"youngs_modulus": "200 GPa", "poisson_ratio": 0.3},
  "surroundings": {"gravity": "9.81 m/s^2"},
  "model": {"physics": ["gravity", "hertz_mindlin", "rolling_resistance"],
    "parameters": {"restitution": {"value": 0.4},
                   "sliding_friction": {"value": 0.5, "range": [0.2, 0.9]},
                   "rolling_friction": {"value": 0.2, "range": [0.1, 0.5]}}},
  "experiments": [{"id": "heap", "rig": "pile",
    "conditions": {"base": "flat", "base_diameter": "48 mm", "grains": 500},
    "recording": "angles.csv"}]
})");
}

// Without what a run's clock and command say.
nlohmann::ordered_json result_of(const Outcome& o) {
    nlohmann::ordered_json json = o.json();
    json.erase("tool");
    return json;
}

}  // namespace

TEST_CASE("calibrate: killed and resumed, on one thread or two, the answer is the same",
          "[app][calibrate][resume]") {
    const Folder f;
    const std::string path = small_calibration(f);
    const auto arguments = [&](const std::string& out, const std::string& threads) {
        return std::vector<std::string>{"calibrate", path,      "--budget", "6", "--confirm",
                                        "2",         "--quiet", "--json",   "-", "--threads",
                                        threads,     "--out",   f / out};
    };
    const Outcome whole = similitude(arguments("whole", "2"));
    INFO(whole.err);
    REQUIRE((whole.code == 0 || whole.code == 3));
    const auto result = result_of(whole);
    CHECK(result["runs"].size() == 8);
    CHECK(result["road"] == "surrogate");
    CHECK(result["estimator"] == "two_h_over_d");
    CHECK(result["targets"][0]["measured"] == Approx(30.0));
    CHECK(result["targets"][0]["standard_deviation"] == Approx(1.0));

    const Outcome stopped = similitude(arguments("parts", "1"), 1500);
    REQUIRE(stopped.code == 130);
    CHECK_THAT(stopped.err, Contains("--resume"));
    std::vector<std::string> again = arguments("parts", "1");
    again.emplace_back("--resume");
    CHECK(result_of(similitude(again)) == result);
    CHECK(contents(f / "parts/runs.csv") == contents(f / "whole/runs.csv"));
}

TEST_CASE("calibrate: the paper's road ends with a ranking and a page", "[app][calibrate]") {
    const Folder f;
    const Outcome o =
        similitude({"calibrate", small_calibration(f), "--road", "paper", "--confirm", "2",
                    "--quiet", "--json", "-", "--out", f / "out", "--report", f / "page.html"});
    INFO(o.err);
    REQUIRE((o.code == 0 || o.code == 3 || o.code == 4));
    CHECK(o.json()["paper"]["ranking"].size() == 2);
    CHECK_THAT(contents(f / "page.html"), Contains("effect in the screening"));
}

// 720 kg/m^3 is 0.6 of the grains: a heap of spheres has that within a tenth.
TEST_CASE("calibrate --bulk-density: the density is a target that fresh heaps have to meet",
          "[app][calibrate]") {
    const Folder f;
    const std::string text = contents(small_calibration(f));
    const auto with_density = [&](const std::string& density) {
        const std::string stated = ",\n  \"stated\": {\"bulk_density\": \"" + density + "\"}\n}\n";
        const std::string path = f.write("dense.json", text.substr(0, text.rfind('}')) + stated);
        return similitude({"calibrate", path, "--bulk-density", "--budget", "6", "--confirm", "2",
                           "--quiet", "--json", "-", "--out", f / "out"});
    };
    const Outcome met = with_density("720 kg/m^3");
    INFO(met.err);
    REQUIRE((met.code == 0 || met.code == 3));
    const auto target = met.json()["targets"][1];
    CHECK(target["name"] == "bulk_density");
    CHECK(target["measured"] == Approx(720.0));
    CHECK(target["standard_deviation"] == Approx(36.0));
    CHECK(target["confirmed"]["heaps"] == 2);
    const Outcome missed = with_density("300 kg/m^3");  // no bed of spheres is that loose
    CHECK(missed.code == 3);
    CHECK(missed.json()["targets"][1]["confirmed"]["agrees"] == false);
}

TEST_CASE("calibrate: a recorded profile is met by the powder that it was recorded of",
          "[app][calibrate]") {
    const Folder f;
    const std::string path = small_calibration(f);
    const Outcome powder =
        similitude({"simulate", path, "--seed", "77", "--out", f / "powder", "--quiet"});
    INFO(powder.err);
    REQUIRE(powder.code == 0);
    f.write("angles.csv", contents(f / "powder/heap.csv"));
    const Outcome o = similitude({"calibrate", path, "--budget", "8", "--confirm", "2", "--quiet",
                                  "--json", "-", "--out", f / "out", "--report", f / "p.html"});
    INFO(o.err);
    REQUIRE((o.code == 0 || o.code == 3));
    const auto json = o.json();
    CHECK(json["estimator"].is_null());
    REQUIRE(json["targets"].size() == 3);
    CHECK(json["targets"][0]["name"] == "height_near_axis");
    for (const auto& target : json["targets"]) {
        // mm; heaps of 500 grains differ by about a grain, 4 mm, from seed to seed.
        CHECK(target["confirmed"]["mean"].get<double>() ==
              Approx(target["measured"].get<double>()).margin(4.0));
    }
    CHECK_THAT(contents(f / "p.html"), Contains("height near axis"));
}

TEST_CASE("calibrate --at: heaps at a given point, with another friction cap or none",
          "[app][calibrate]") {
    const Folder f;
    const std::string path = small_calibration(f);
    const auto at = [&](std::vector<std::string> more) {
        std::vector<std::string> all{"calibrate", path,     "--at",   "sliding_friction=0.4",
                                     "--confirm", "2",      "--seed", "5",
                                     "--quiet",   "--json", "-",      "--out",
                                     f / "out"};
        all.insert(all.end(), more.begin(), more.end());
        return similitude(all);
    };
    const Outcome o = at({"--report", f / "page.html"});
    INFO(o.err);
    REQUIRE((o.code == 0 || o.code == 3));
    const auto json = o.json();
    CHECK(json["road"] == "none");
    CHECK(json["runs"].size() == 2);
    CHECK(json["runs"][1]["seed"] == 6);
    CHECK(json["answer"] == nlohmann::ordered_json{0.2, 0.4});
    CHECK_THAT(contents(f / "page.html"), Contains("the given point"));
    const Outcome capped = at({"--friction-cap", "total_plus_two_pull_off"});
    CHECK(capped.json()["runs"][0]["values"] != json["runs"][0]["values"]);
    CHECK_THAT(at({"--road", "paper"}).err, Contains("--at"));
    CHECK_THAT(at({"--replay"}).err, Contains("--replay"));
    const Outcome wrong = at({"--friction-cap", "repulsive"});
    CHECK(wrong.code == 2);
    CHECK_THAT(wrong.err, Contains("repulsive_part"));
}

TEST_CASE("calibrate: what is missing is asked for", "[app][calibrate][input]") {
    const Folder f;
    const std::string small = small_calibration(f);
    const Outcome road = similitude({"calibrate", small, "--road", "shorter"});
    CHECK(road.code == 2);
    CHECK_THAT(road.err, Contains("--road") && Contains("surrogate"));
    const Outcome pile = similitude({"calibrate", small, "--experiment", "heaps"});
    CHECK(pile.code == 2);
    CHECK_THAT(pile.err, Contains("heap"));
    const Outcome funnel = similitude({"calibrate", "data/zirconia/case.json"});
    CHECK(funnel.code == 2);
    CHECK_THAT(funnel.err, Contains("grains"));
    const std::string path = f.write("tiny.json", tiny_case());
    const Outcome none = similitude({"calibrate", path, "--replay"});
    CHECK(none.code == 2);
}
