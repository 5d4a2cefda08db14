// SPDX-License-Identifier: MIT
// `similitude photo` as a user types it. The picture is made here: plain PPM is not read, so it goes through the page's own JPEG writer.
#include "command_line.hpp"
#include "photo/picture.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

using Catch::Contains;
using Json = nlohmann::ordered_json;

namespace {

constexpr double deg = std::numbers::pi / 180.0;

// A dark triangle of 120 pixels in height and 30 deg on light ground, its base at y = 240; the edge is as sharp as a quarter of a pixel.
std::string triangle(double contrast = 130.0) {
    photo::Picture p{560, 300, {}, 1};
    for (int y = 0; y < 300; ++y)
        for (int x = 0; x < 560; ++x) {
            int count = 0;
            for (int k = 0; k < 16; ++k) {
                const double px = x - 0.375 + 0.25 * (k % 4), py = y - 0.375 + 0.25 * (k / 4);
                count +=
                    py < 240.0 && 240.0 - py < 120.0 - std::tan(30.0 * deg) * std::abs(px - 280.0);
            }
            const double tone = 200.0 - contrast * count / 16.0;
            for (int c = 0; c < 3; ++c)
                p.rgb.push_back(static_cast<std::uint8_t>(std::lround(tone)));
        }
    return photo::jpeg_of(p);
}

std::string complaint(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "photo");
    const Outcome o = similitude(arguments);
    CHECK(o.code == 2);
    CHECK(o.out.empty());
    return o.err;
}

}  // namespace

TEST_CASE("photo: angle as JSON, page with the picture in it, profile a case of the rig pile reads",
          "[app][photo]") {
    const Folder folder;
    const std::string image = folder.write("heap.jpg", triangle());
    const Outcome o =
        similitude({"photo", image, "--known", "72.2,240 487.8,240 = 40 mm", "--json", "-",
                    "--report", folder / "heap.html", "--profile", folder / "heap.csv"});
    INFO(o.err);
    REQUIRE(o.code == 0);
    const Json j = o.json(), a = j.at("angle_of_repose");
    CHECK(j.at("format") == "similitude-photo/1");
    CHECK(a.at("estimator") == "silhouette");
    CHECK(a.at("angle").get<double>() == Approx(30.0 * deg).margin(0.3 * deg));
    CHECK(a.at("interval")[0].get<double>() < a.at("angle").get<double>());
    CHECK(a.at("interval")[1].get<double>() > a.at("angle").get<double>());
    CHECK(a.at("left").at("angle").get<double>() == Approx(30.0 * deg).margin(0.3 * deg));
    // 40 mm over 2 x 120 / tan 30 deg = 415.7 pixels, by hand.
    CHECK(j.at("metres_per_pixel").at("value").get<double>() == Approx(40e-3 / 415.6));
    CHECK(j.at("height").at("m").get<double>() == Approx(120.0 * 40e-3 / 415.7).epsilon(0.02));
    CHECK(j.at("foot_width").at("m").get<double>() == Approx(40e-3).epsilon(0.03));
    CHECK(j.at("tilt").at("angle").get<double>() == Approx(0.0).margin(0.2 * deg));

    const std::string page = contents(folder / "heap.html");
    CHECK_THAT(page, Contains("data:image/jpeg;base64,/9j/"));
    CHECK_THAT(page, Contains("Angle of repose 30."));
    CHECK_THAT(page, Contains("What this does not show"));
    CHECK(page.find("{{") == std::string::npos);

    std::istringstream csv(contents(folder / "heap.csv"));
    std::string line;
    std::getline(csv, line);
    CHECK(line == "azimuth [rad],r [m],z [m]");
    const std::string text = R"({"format": "similitude-case/1", "title": "t",
      "grain": {"diameter": "1 mm", "density": "2500 kg/m^3", "youngs_modulus": "5 MPa", "poisson_ratio": 0.3},
      "plate": {"youngs_modulus": "5 MPa", "poisson_ratio": 0.3},
      "surroundings": {"gravity": "9.81 m/s^2", "fluid_density": "0 kg/m^3", "fluid_viscosity": "0 Pa*s"},
      "model": {"physics": ["gravity", "hertz_mindlin"], "parameters": {"restitution": {"value": 0.5}, "sliding_friction": {"value": 0.5}}},
      "experiments": [{"id": "a", "rig": "pile", "conditions": {"base": "flat", "base_diameter": "40 mm", "grains": 100}, "recording": "heap.csv"}]})";
    const std::string path = folder.write("case.json", text);
    const Outcome read = similitude({"scale", path, "--scheme", "exact", "--quiet"});
    INFO(read.err);
    CHECK(read.err.find("heap.csv") == std::string::npos);
}

TEST_CASE("photo: the foot's width as a scale, words for a person", "[app][photo]") {
    const Folder folder;
    const std::string image = folder.write("heap.jpg", triangle());
    const Outcome o =
        similitude({"photo", image, "--foot-width", "40 mm", "--looking-down", "0 deg"});
    REQUIRE(o.code == 0);
    CHECK_THAT(o.out, Contains("Angle of repose 30.") || Contains("Angle of repose 29."));
    CHECK_THAT(o.out, Contains("foot 40 mm wide"));
    CHECK_THAT(o.out, !Contains("taken to look level"));
    CHECK_THAT(similitude({"photo", image}).out, Contains("taken to look level"));
}

TEST_CASE("photo: a picture in which there is no heap is an answer, exit 4, with a page",
          "[app][photo]") {
    const Folder folder;
    const Outcome o = similitude({"photo", folder.write("grey.jpg", triangle(0.0)), "--json", "-",
                                  "--report", folder / "grey.html"});
    CHECK(o.code == 4);
    CHECK(o.json().at("angle_of_repose").is_null());
    CHECK(o.json().at("answer") == "cannot tell");
    CHECK(o.json().at("findings").back().at("judgement") == "unusable");
    CHECK_THAT(contents(folder / "grey.html"), Contains("No angle can be read from this picture"));
}

TEST_CASE("photo: bad input names place, value, rule, remedy", "[app][photo][input]") {
    const Folder folder;
    const std::string image = folder.write("heap.jpg", triangle());
    CHECK_THAT(complaint({folder / "none.jpg"}),
               Contains("none.jpg: got a file that cannot be read"));
    CHECK_THAT(complaint({folder.write("x.heic", "ftypheic")}), Contains("export HEIC"));
    CHECK_THAT(complaint({image, "--profile", folder / "p.csv"}),
               Contains("--profile: got a picture without a scale") && Contains("--known"));
    CHECK_THAT(complaint({image, "--known", "1,2 300,4"}), Contains("= 50 mm"));
    CHECK_THAT(complaint({image, "--known", "1,2 300,4 = 50"}),
               Contains("--known") && Contains("50 m"));
    CHECK_THAT(complaint({image, "--known", "1,2 3,4 = 5 mm"}), Contains("at least 10"));
    CHECK_THAT(complaint({image, "--base", "1,2,3"}), Contains("two points \"x1,y1 x2,y2\""));
    CHECK_THAT(complaint({image, "--base", "1,2 3000,4"}),
               Contains("base: got 3000,4") && Contains("560 x 300"));
    CHECK_THAT(complaint({image, "--looking-down", "5"}), Contains("--looking-down"));
    CHECK_THAT(complaint({image, "--heap", "blue"}), Contains("--heap"));
    CHECK_THAT(complaint({image, "--foot-width", "4 kg"}), Contains("--foot-width"));
}
