// SPDX-License-Identifier: MIT
#include "command_line.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <vector>

namespace {

using Json = nlohmann::ordered_json;

const std::string flour = "data/advice/flour.json";

Outcome advise(const Folder& f, std::vector<std::string> more) {
    std::vector<std::string> all = {"advise",  flour,     "--tolerance", "3 deg",     "--out",
                                    f / "out", "--quiet", "--json",      f / "a.json"};
    all.insert(all.end(), more.begin(), more.end());
    return similitude(all);
}

double si(const Json& text) { return std::stod(text.get<std::string>()); }

}  // namespace

TEST_CASE("advise: the case that it writes is the powder's with a larger grain", "[app][advise]") {
    const Folder f;
    const Outcome o = advise(f, {"--budget", "1 s"});
    INFO(o.err);
    REQUIRE((o.code == 4 || o.code == 5));  // the powder is far finer than the map
    const Json j = Json::parse(contents(f / "a.json"));
    const Json chosen = j.at("considered").at(j.at("chosen").get<std::size_t>());
    const double h = chosen.at("h");
    CHECK(chosen.at("time_of_a_heap").at("value") <= 1.0);
    CHECK_FALSE(chosen.at("coarse_graining").at("beyond_the_map").empty());
    const Json written = Json::parse(contents(f / "out/advised/case.json"));
    CHECK(si(written.at("grain").at("diameter")) == Approx(80e-6 * h));
    double cubes = 0.0;  // five sizes, whose mean volume is that of the grain
    for (const Json& row : written.at("grain").at("sizes")) cubes += std::pow(si(row[0]), 3.0);
    REQUIRE(written.at("grain").at("sizes").size() == 5);
    CHECK(cubes / 5.0 == Approx(std::pow(80e-6 * h, 3.0)).epsilon(1e-6));
    CHECK(chosen.at("rule") == "stress_bond");  // w ~ h
    CHECK(si(written.at("model").at("parameters").at("work_of_adhesion").at("value")) ==
          Approx(0.33e-3 * h));
    CHECK(written.at("experiments").at(0).at("conditions").at("base_diameter") == "50 mm");
    CHECK(si(written.at("grain").at("youngs_modulus")) ==
          Approx(1e9 * chosen.at("softening").get<double>()));
}

TEST_CASE("advise --check: heaps of the advised grain stand beside those of a finer one",
          "[app][advise]") {
    const Folder f;
    const Outcome o =
        advise(f, {"--budget", "500 ms", "--check", "--seeds", "2", "--report", f / "a.html"});
    INFO(o.err);
    REQUIRE(o.code != 2);
    const Json check = Json::parse(contents(f / "a.json")).at("check");
    CHECK(check.at("reference").at("samples").size() == 2);
    CHECK(check.at("scaled").at("samples").size() == 2);
    CHECK(contents(f / "a.html").find("Grains in place of the powder") != std::string::npos);
    const Outcome again = advise(f, {"--budget", "500 ms", "--check", "--seeds", "2", "--resume"});
    CHECK(Json::parse(contents(f / "a.json")).at("check").at("scaled").at("samples") ==
          check.at("scaled").at("samples"));
}

TEST_CASE("advise: what cannot be is said with its place and remedy", "[app][advise]") {
    const Folder f;
    CHECK(advise(f, {"--budget", "-1 s"}).err.find("--budget") != std::string::npos);
    CHECK(advise(f, {"--budget", "1 s", "--map", f / "none.json"}).code == 2);
    const Outcome drop = similitude({"advise", "data/recordings/falling_balls/whiffle/case.json",
                                     "--budget", "1 s", "--tolerance", "1 deg"});
    CHECK(drop.code == 2);
    CHECK(drop.err.find("must hold a pile") != std::string::npos);
    // Years for the powder itself, and no grain for nothing.
    const Outcome poor = advise(f, {"--budget", "1 us"});
    CHECK(poor.code == 3);
}
