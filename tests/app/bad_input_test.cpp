// SPDX-License-Identifier: MIT
// A user's mistake: exit 2 and one line that says where, what was given, the rule and the way out.
#include "command_line.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace {

void expect_complaint(const Outcome& o, const std::vector<std::string>& parts) {
    INFO(o.err);
    CHECK(o.code == 2);
    CHECK(o.out.empty());
    CHECK(std::count(o.err.begin(), o.err.end(), '\n') == 1);
    for (const std::string& part : parts) {
        INFO(part);
        CHECK(o.err.find(part) != std::string::npos);
    }
}

Outcome scaled(const Folder& folder, const std::string& text) {
    return similitude({"scale", folder.write("case.json", text), "--h", "10", "--scheme", "exact"});
}

}  // namespace

TEST_CASE("bad input: a length without a unit", "[app][input]") {
    const Folder f;
    expect_complaint(scaled(f, tiny_case("\"1 mm\"", "1")),
                     {"case.json: grain.diameter", "got 1", "must be a length", "write \"1 m\""});
}

TEST_CASE("bad input: a unit of another dimension", "[app][input]") {
    const Folder f;
    expect_complaint(scaled(f, tiny_case("2500 kg/m^3", "2500 kg")),
                     {"grain.density", "2500 kg", "must be a density", "write it in kg/m^3"});
}

TEST_CASE("bad input: a key that nobody knows", "[app][input]") {
    const Folder f;
    expect_complaint(scaled(f, tiny_case("\"density\"", "\"densty\"")),
                     {"grain", "densty", "must", "density"});
}

TEST_CASE("bad input: a negative diameter", "[app][input]") {
    const Folder f;
    expect_complaint(scaled(f, tiny_case("\"1 mm\"", "\"-1 mm\"")),
                     {"grain.diameter", "-1 mm", "must be > 0"});
}

TEST_CASE("bad input: a file that ends in the middle", "[app][input]") {
    const Folder f;
    const std::string text = tiny_case();
    expect_complaint(scaled(f, text.substr(0, text.size() / 2)), {"case.json", "must"});
}

TEST_CASE("bad input: a recording without a line", "[app][input]") {
    const Folder f;
    f.write("pile.csv", "");
    expect_complaint(
        scaled(f, tiny_case("\"rig\": \"pile\",", R"("rig": "pile", "recording": "pile.csv",)")),
        {"pile.csv", "must"});
}

TEST_CASE("bad input: a size distribution that falls", "[app][input]") {
    const Folder f;
    const std::string falling =
        R"("diameter": "1 mm", "size_distribution": [["10 %", "1 mm"], ["50 %", "0.5 mm"], ["90 %", "2 mm"]],)";
    expect_complaint(scaled(f, tiny_case(R"("diameter": "1 mm",)", falling)),
                     {"size_distribution", "0.5 mm", "must"});
}

TEST_CASE("bad input: a scheme misspelled is answered with the nearest one", "[app][input]") {
    const Folder f;
    const std::string path = f.write("case.json", tiny_case());
    expect_complaint(similitude({"scale", path, "--h", "10", "--scheme", "exakt"}),
                     {"exakt", "did you mean exact?"});
}

TEST_CASE(
    "bad input: without h, scheme or a needed invariant the program asks, and says what each keeps",
    "[app][input]") {
    const Folder f;
    const std::string path = f.write("case.json", tiny_case());
    expect_complaint(similitude({"scale", path, "--scheme", "exact"}), {"scaling.h", "--h"});
    expect_complaint(similitude({"scale", path, "--h", "10"}),
                     {"scaling.scheme", "--scheme", "kept_gravity"});
    expect_complaint(similitude({"scale", path, "--h", "10", "--scheme", "paper"}),
                     {"scaling.invariant", "weight_bond keeps", "stress_bond keeps",
                      "cohesion_number keeps", "sticking_velocity keeps"});
}

TEST_CASE("bad input: an adhesion must say its unit and whose it is", "[app][input]") {
    const Folder f;
    const std::string path = f.write("case.json", tiny_case());
    const std::vector<std::string> start = {"scale", path, "--h", "10", "--scheme", "exact"};
    const auto with = [&](std::vector<std::string> more) {
        std::vector<std::string> all = start;
        all.insert(all.end(), more.begin(), more.end());
        return similitude(all);
    };
    expect_complaint(with({"--surface-energy", "0.19", "--of", "scaled"}),
                     {"--surface-energy", "0.19 J/m^2"});
    expect_complaint(with({"--surface-energy", "0.19 J/m^3", "--of", "scaled"}),
                     {"--surface-energy", "0.19 J/m^2"});
    expect_complaint(with({"--work-of-adhesion", "0.38 J/m^2"}),
                     {"--work-of-adhesion", "--of original", "--of scaled"});
}

TEST_CASE("bad input: unknown verbs, options and files are one line as well", "[app][input]") {
    expect_complaint(
        similitude({"scale", "data/zirconia", "--quiet", "--report", "/dev/null/a.html"}),
        {"/dev/null/a.html", "must be writable"});
    expect_complaint(similitude({"scale", "data/zirconia", "--h", "-5"}), {"-5", "must"});
    expect_complaint(similitude({"scael", "x"}), {"scael", "did you mean scale?"});
    expect_complaint(similitude({}), {"scale, simulate, verify"});
    expect_complaint(similitude({"scale"}), {"CASE"});
    expect_complaint(similitude({"scale", "nowhere/case.json"}), {"nowhere/case.json"});
    expect_complaint(similitude({"scale", "x", "--threads", "many"}), {"threads"});
}

TEST_CASE("bad input: a run that would take for ever is refused with its estimate",
          "[app][input]") {
    const Folder f;
    const std::string endless = f.write("case.json", tiny_case("300", "\"until_it_spills\""));
    expect_complaint(similitude({"simulate", endless, "--out", f / "out"}),
                     {"conditions.grains", "until_it_spills", "scale the powder"});
    const std::string large = f.write("case.json", tiny_case("300", "900000000"));
    expect_complaint(similitude({"simulate", large, "--out", f / "out"}), {"9e8 grains", "--yes"});
    const std::string stiff = f.write("case.json", tiny_case("1 MPa", "1e9 GPa"));
    expect_complaint(similitude({"simulate", stiff, "--out", f / "out"}),
                     {"300 grains x", "12 h", "--yes"});
}
