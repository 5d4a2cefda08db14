// SPDX-License-Identifier: MIT
// Whenever a run is stopped, by whatever signal, it goes on to the files of one that never stopped.
#include "command_line.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> command(const std::string& path, const std::string& out) {
    return {"simulate",
            path,
            "--out",
            out,
            "--threads",
            "1",
            "--dump",
            "lammps,vtp,extxyz",
            "--dump-every",
            "20 ms",
            "--checkpoint-every",
            "60 ms",
            "--yes"};
}

// The words with another value behind `option`.
std::vector<std::string> with(std::vector<std::string> words, const std::string& option,
                              const std::string& value) {
    const auto at = std::find(words.begin(), words.end(), option);
    REQUIRE(at != words.end());
    *(at + 1) = value;
    return words;
}

// Every file of a folder but run.json, which tells wall times.
std::map<std::string, std::string> files_in(const std::string& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && entry.path().filename() != "run.json")
            files[std::filesystem::relative(entry.path(), folder)] = contents(entry.path());
    return files;
}

Json run_in(const std::string& folder) {
    return Json::parse(contents(folder + "/run.json")).at("runs").at(0);
}

void expect_same(const std::string& folder, const std::string& whole) {
    CHECK(run_in(folder).at("result") == run_in(whole).at("result"));  // the hash among others
    CHECK(run_in(folder).at("dumps") == run_in(whole).at("dumps"));
    const auto got = files_in(folder), expected = files_in(whole);
    CHECK(got.size() == expected.size());
    for (const auto& [name, text] : expected) {
        INFO(name);
        REQUIRE(got.count(name) == 1);
        CHECK((got.at(name) == text));  // in brackets: a failure must not print megabytes
    }
}

std::size_t checkpoints_in(const std::string& folder) {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        files += entry.path().extension() == ".checkpoint";
    return files;
}

// ms that a run takes here and now.
int duration(const std::string& whole) {
    return static_cast<int>(1000.0 * run_in(whole).at("wall_time").get<double>());
}

}  // namespace

TEST_CASE(
    "resume: a run killed at random moments again and again loses nothing and doubles nothing",
    "[app][resume]") {
    const Folder f;
    const std::string path = f.write("case.json", tiny_case("\"grains\": 300", "\"grains\": 150"));
    REQUIRE(similitude(command(path, f / "whole")).code == 0);
    const int time = duration(f / "whole");
    std::mt19937 chance(20260131);  // any seed; the moments depend on the machine's load as well
    for (const int signal : {SIGTERM, SIGKILL}) {
        int stopped = 0, checkpoints = 0;
        for (int run = 0; run < 3; ++run) {
            const std::string out = f / (std::to_string(signal) + "-" + std::to_string(run));
            std::vector<std::string> words = command(path, out);
            Outcome o{-1, "", ""};
            // Each part is long enough for a checkpoint, so that the run comes to its end.
            for (int part = 0; part < 40 && o.code != 0; ++part) {
                const int after = std::uniform_int_distribution(time / 5, 4 * time / 5)(chance);
                o = similitude(words, {{after, signal}});
                INFO(o.err);
                const bool as_expected =
                    o.code == 0 || o.code == (signal == SIGTERM ? 130 : 1000 + SIGKILL);
                REQUIRE(as_expected);
                stopped += o.code != 0;
                if (o.code == 130) CHECK(checkpoints_in(out) == 1);  // older ones are gone
                if (o.code != 0) checkpoints += std::filesystem::exists(out + "/pile.state.json");
                if (part == 0) words.push_back("--resume");
            }
            REQUIRE(o.code == 0);
            expect_same(out, f / "whole");
        }
        CHECK(stopped > 0);
        CHECK(checkpoints > 0);
        if (signal == SIGTERM) CHECK(checkpoints == stopped);  // SIGTERM itself makes one
    }
}

TEST_CASE("resume: Ctrl-C pressed again and again does not cost the checkpoint", "[app][resume]") {
    const Folder f;
    const std::string path = f.write("case.json", tiny_case());
    REQUIRE(similitude(command(path, f / "whole")).code == 0);
    std::vector<std::string> words = command(path, f / "part");
    words = with(words, "--checkpoint-every", "1 h");  // no checkpoint but that of the signal
    const int soon = duration(f / "whole") / 3;
    const Outcome part =
        similitude(words, {{soon, SIGINT}, {1, SIGINT}, {1, SIGINT}, {1, SIGTERM}});
    INFO(part.err);
    REQUIRE(part.code == 130);
    REQUIRE(std::filesystem::exists(f / "part/pile.state.json"));
    words.push_back("--resume");
    REQUIRE(similitude(words).code == 0);
    expect_same(f / "part", f / "whole");
}

TEST_CASE("resume: other dumps than before the interrupt, and a dump cut short, are refused",
          "[app][resume][input]") {
    const Folder f;
    const std::string path = f.write("case.json", tiny_case());
    REQUIRE(similitude(command(path, f / "whole")).code == 0);
    std::vector<std::string> words = command(path, f / "part");
    REQUIRE(similitude(words, {{duration(f / "whole") / 2, SIGTERM}}).code == 130);
    words.push_back("--resume");
    const auto refused = [&](const std::vector<std::string>& changed, const std::string& message) {
        const Outcome o = similitude(changed);
        INFO(o.err);
        CHECK(o.code == 2);
        CHECK(o.err.find(message) != std::string::npos);
    };
    refused(with(words, "--dump", "lammps"),
            "--dump: got lammps, must be lammps, vtp, extxyz as before the interrupt");
    refused(with(words, "--dump-every", "30 ms"),
            "--dump-every: got 30 ms, must be 20 ms as before the interrupt");

    const std::string vtp = f / "part/pile-vtp/frame-000001.vtp", text = contents(vtp);
    std::filesystem::remove(vtp);
    refused(words, "frame-000001.vtp: got no file");
    f.write("part/pile-vtp/frame-000001.vtp", text);
    const std::string dump = f / "part/pile.lammpstrj";
    std::filesystem::resize_file(dump, 1000);
    refused(words, "pile.lammpstrj: got 1000 bytes");
    std::filesystem::remove(dump);
    refused(words, "pile.lammpstrj: got no file");
}

TEST_CASE("resume: what was finished before the interrupt is not run again", "[app][resume]") {
    const Folder f;
    const std::string last = R"("grains": 300}}])";
    const std::string path =
        f.write("case.json", tiny_case(last, R"("grains": 30}}, {"id": "later", "rig": "pile",
    "conditions": {"base": "glued_grains", "base_diameter": "10 mm", "grains": 300}}])"));
    REQUIRE(similitude(command(path, f / "whole")).code == 0);
    const Json whole = Json::parse(contents(f / "whole/run.json")).at("runs");
    // In the middle of the second pile.
    const double seconds =
        whole.at(0).at("wall_time").get<double>() + 0.5 * whole.at(1).at("wall_time").get<double>();
    std::vector<std::string> words = command(path, f / "part");
    REQUIRE(similitude(words, {{static_cast<int>(1000.0 * seconds), SIGTERM}}).code == 130);
    REQUIRE(std::filesystem::exists(f / "part/pile.csv"));
    REQUIRE(std::filesystem::exists(f / "part/later.state.json"));
    const auto written = std::filesystem::last_write_time(f / "part/pile-vtp/frame-000000.vtp");
    words.push_back("--resume");
    REQUIRE(similitude(words).code == 0);
    CHECK(std::filesystem::last_write_time(f / "part/pile-vtp/frame-000000.vtp") == written);
    expect_same(f / "part", f / "whole");
    const Json rest = Json::parse(contents(f / "part/run.json")).at("runs");
    CHECK(rest.at(1).at("result") == whole.at(1).at("result"));
}

TEST_CASE(
    "resume: a mesh that changed since the interrupt is refused; run.json names and hashes it",
    "[app][resume][input]") {
    const Folder f;
    const auto wall = [&](const std::string& height) {
        f.write("wall.stl", "solid wall\nfacet normal 0 0 1\nouter loop\nvertex -9 -9 " + height +
                                "\nvertex 9 -9 " + height + "\nvertex 0 9 " + height +
                                "\nendloop\nendfacet\nendsolid wall\n");
    };
    wall("-9");
    std::string text = tiny_case(R"("grains": 300)",
                                 R"("grains": 300, "drop_height": "5 mm", "feed_diameter": "6 mm",
      "mesh": {"file": "wall.stl", "unit": "mm"})");
    text.insert(text.find("\"model\""),
                "\"plate\": {\"youngs_modulus\": \"1 MPa\", \"poisson_ratio\": 0.3},\n  ");
    const std::string path = f.write("case.json", text);
    REQUIRE(similitude(command(path, f / "whole")).code == 0);
    const auto inputs = [&](const std::string& folder) {
        return Json::parse(contents(f / (folder + "/run.json"))).at("inputs");
    };
    REQUIRE(inputs("whole").size() == 2);
    CHECK(inputs("whole").at(1).at("path").get<std::string>().ends_with("wall.stl"));

    std::vector<std::string> words = command(path, f / "part");
    REQUIRE(similitude(words, {{duration(f / "whole") / 3, SIGTERM}}).code == 130);
    words.push_back("--resume");
    wall("-8");
    const Outcome other = similitude(words);
    INFO(other.err);
    CHECK(other.code == 2);
    CHECK(other.err.find("must belong to this case, seed and version") != std::string::npos);
    wall("-9");
    REQUIRE(similitude(words).code == 0);
    expect_same(f / "part", f / "whole");
    CHECK(inputs("part") == inputs("whole"));
}
