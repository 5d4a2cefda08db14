// SPDX-License-Identifier: MIT
// A campaign around a judge: what becomes of a judge that crashes, hangs or is interrupted.
#include "command_line.hpp"

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

// A program that is called as `similitude diagnose FOLDER --json FILE ...`; FILE is its fourth word.
std::string judge(const Folder& home, const std::string& what_it_does) {
    const std::string path = home.write("judge", "#!/bin/sh\n" + what_it_does + "\n");
    fs::permissions(path, fs::perms::owner_all);
    return path;
}

const std::string says_consistent = R"(cat > "$4" <<END
{"format": "similitude-verdict/1", "verdict": "consistent", "located": [], "effects": [],
 "hypotheses": [{"effects": [], "probability": 1}], "held_out": null, "next_experiment": null}
END)";

std::vector<std::string> nulls(const Folder& home, const std::string& judge_program,
                               const std::vector<std::string>& more) {
    std::vector<std::string> words = {"prove",  "--cases", "4",           "--seed", "7",
                                      "--kind", "null",    "--rig",       "drop",   "--threads",
                                      "2",      "--judge", judge_program, "--out",  home / "out",
                                      "--json", "-",       "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

std::string how_it_ended(const Folder& home, const std::string& name) {
    std::ifstream in(home / ("out/verdicts/" + name + ".ended"));
    return nlohmann::ordered_json::parse(in).at("ended");
}

std::string first_case(const Folder& home) {
    std::string first;
    for (const auto& entry : fs::directory_iterator(home / "out/cases")) {
        const std::string name = entry.path().filename().string();
        if (first.empty() || name < first) first = name;
    }
    return first;
}

}  // namespace

TEST_CASE("a judge that finds nothing on nulls raises no false alarm", "[prove]") {
    const Folder home;
    const Outcome o = similitude(nulls(home, judge(home, says_consistent), {}));
    const auto table = o.json();
    REQUIRE(table.at("cases") == 4);
    REQUIRE(table.at("without_verdict") == 0);
    REQUIRE(table.at("cpu_seconds_per_case").at("failures") == 0);
    const auto& alarms = table.at("lines").at(0);
    REQUIRE(alarms.at("count") == 4);
    REQUIRE(alarms.at("value") == 0.0);
}

TEST_CASE("a judge that crashes is wrong in its case and stops no campaign", "[prove]") {
    const Folder home;
    const Outcome o = similitude(nulls(home, judge(home, "echo no luck >&2; kill -SEGV $$"), {}));
    REQUIRE(o.code == 3);
    REQUIRE(o.json().at("without_verdict") == 4);
    REQUIRE(o.json().at("cpu_seconds_per_case").at("failures") == 4);
    REQUIRE(how_it_ended(home, first_case(home)) == "signal 11");
    REQUIRE(contents(home / ("out/verdicts/" + first_case(home) + ".ended")).find("no luck") !=
            std::string::npos);
}

TEST_CASE("a judge that never ends is ended, and what it wrote is no verdict", "[prove]") {
    const Folder home;
    const Outcome o = similitude(
        nulls(home, judge(home, says_consistent + "\nwhile :; do :; done"), {"--limit", "1"}));
    REQUIRE(o.json().at("without_verdict") == 4);
    REQUIRE(how_it_ended(home, first_case(home)) == "out of time");
}

TEST_CASE("a verdict counts only with an exit code of a verdict", "[prove]") {
    const Folder home;
    const Outcome o = similitude(nulls(home, judge(home, says_consistent + "\nexit 2"), {}));
    REQUIRE(o.json().at("without_verdict") == 4);
    REQUIRE(how_it_ended(home, first_case(home)) == "exit 2");
}

TEST_CASE("a campaign that was interrupted goes on where it stopped", "[prove]") {
    const Folder home;
    // Each judgement leaves a line; the first two of this judge take longer than the interrupt.
    const std::string log = home / "log";
    const std::string slow = "echo $2 >> " + log + "; test -e " + log + ".go || sleep 60\n";
    const std::string program = judge(home, slow + says_consistent);
    const Outcome stopped = similitude(nulls(home, program, {}), 3000);
    REQUIRE(stopped.code == 130);
    REQUIRE(stopped.err.find("--resume") != std::string::npos);
    home.write("log.go", "");
    const Outcome resumed = similitude(nulls(home, program, {"--resume"}));
    REQUIRE(resumed.json().at("without_verdict") == 0);
    const std::string judged = contents(log);
    const Outcome again = similitude(nulls(home, program, {"--resume"}));
    REQUIRE(contents(log) == judged);  // nothing was judged twice
    auto a = resumed.json(), b = again.json();
    a.erase("tool"), b.erase("tool");
    REQUIRE(a == b);
    const Outcome scored = similitude(nulls(home, program, {"--score-only"}));
    REQUIRE(scored.json().at("lines") == b.at("lines"));
}

TEST_CASE("the program's own judge takes a blind case and answers", "[prove]") {
    const Folder home;
    const Outcome o =
        similitude({"prove", "--cases", "1", "--seed", "7", "--kind", "null", "--rig", "impact",
                    "--out", home / "out", "--json", "-", "--quiet", "--limit", "60"});
    REQUIRE((o.code == 0 || o.code == 3));
    REQUIRE(o.json().at("without_verdict") == 0);
}
