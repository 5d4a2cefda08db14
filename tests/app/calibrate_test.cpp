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

TEST_CASE("calibrate: what is missing is asked for", "[app][calibrate][input]") {
    const Folder f;
    const Outcome plain = similitude({"calibrate", "data/zirconia/case.json"});
    CHECK(plain.code == 2);
    CHECK_THAT(plain.err, Contains("--replay"));
    const std::string path = f.write("case.json", tiny_case());
    const Outcome none = similitude({"calibrate", path, "--replay"});
    CHECK(none.code == 2);
}
