// SPDX-License-Identifier: MIT
#include "reports/photo.hpp"

#include "reports/page.hpp"
#include "samples.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>
#include <string>

using namespace reports;
using Catch::Contains;

namespace {

constexpr double deg = std::numbers::pi / 180.0;

photo::Picture grey() { return {64, 40, std::vector<std::uint8_t>(3 * 64 * 40, 128), 4}; }

// Made up by hand: 30 and 34 deg, in a picture of 256 x 160 pixels.
photo::Measurement measured() {
    photo::Heaped h{};
    h.left = {.angle = 30 * deg,
              .standard_error = 0.1 * deg,
              .interval = {29 * deg, 31 * deg},
              .roughness = 1.5,
              .pieces = 20.0,
              .foot = {60, 120},
              .top = {100, 90}};
    h.right = {.angle = 34 * deg,
               .standard_error = 0.1 * deg,
               .interval = {33 * deg, 35 * deg},
               .roughness = 1.5,
               .pieces = 20.0,
               .foot = {190, 120},
               .top = {150, 90}};
    h.angle = 32 * deg, h.interval = {28 * deg, 36 * deg};
    h.parts = {
        .roughness = 0.1 * deg, .light = 0.02 * deg, .difference = 2 * deg, .total = 2.003 * deg};
    h.tilt = -1.5 * deg, h.tilt_error = 0.05 * deg;
    h.base_left = {0, 128}, h.base_right = {255, 132};
    h.height = 50.0, h.foot_width = 160.0, h.width_error = 2.0;
    photo::Measurement m;
    m.heap = h;
    m.edge = {{60, 120}, {64, 117}, {68, 114}, {150, 90}, {154, 93}};  // a gap between
    m.findings = {{"contrast_to_noise", 9.0, ">= 3", scaling::Judgement::fine, ""},
                  {"flanks_differ_degrees", 4.0, "<= 90", scaling::Judgement::caution,
                   "Left & right differ"}};
    return m;
}

std::string page_of(const photo::Measurement& m) {
    Page page{.title = "heap.jpg", .verdict = verdict_of(m)};
    page.runs = {photo_section("Edge", grey(), m, std::nullopt)};
    page.runs_heading = "The picture";
    page.limits = limits_of(m);
    return html(page);
}

}  // namespace

TEST_CASE("photo: the page has the picture with edge, base line, flanks and both angles over it",
          "[reports][photo]") {
    const std::string text = page_of(measured());
    CHECK(fault_in_markup(text) == "");
    CHECK(times_in(text, "data:image/jpeg;base64,") == 1);
    CHECK(times_in(text, "viewBox=\"0 0 256 160\"") ==
          1);  // places are those of the file, not of what it was reduced to
    CHECK(times_in(text, "30.0\u00b0</text>") == 1);
    CHECK(times_in(text, "34.0\u00b0</text>") == 1);
    CHECK(times_in(text, "<polyline") == 4);  // two pieces, each with its halo
    CHECK(times_in(text, "Left &amp; right differ") == 1);
    CHECK(times_in(text, "1.50 \u00b1 0.10 deg, rising to the left") == 1);
    CHECK(times_in(text, "Angle of repose 32.00 deg, 95 % between 28.00 and 36.00 deg") >= 1);
    CHECK(times_in(text, "nan") == 0);
}

TEST_CASE("photo: JSON in radians and metres, none where there is none", "[reports][photo]") {
    const Json j = to_json(measured(), PhotoScale{1e-4, 0.01});
    CHECK(j.at("answer") == "yes");
    CHECK(j.at("angle_of_repose").at("angle").get<double>() == Approx(32 * deg));
    CHECK(j.at("angle_of_repose").at("right").at("interval")[1].get<double>() == Approx(35 * deg));
    CHECK(j.at("two_h_over_d").is_null());
    CHECK(j.at("foot_width").at("m").get<double>() == Approx(16e-3));
    // 2 pixels and 1 %: sqrt(0.2^2 + 0.16^2) mm.
    CHECK(j.at("foot_width").at("m_standard_error").get<double>() ==
          Approx(std::hypot(0.2e-3, 0.16e-3)));
    CHECK(!to_json(measured(), std::nullopt).at("height").contains("m"));
}

TEST_CASE("photo: a refusal says which rule forbade an angle", "[reports][photo]") {
    photo::Measurement m;
    m.findings = {
        {"contrast_to_noise", 1.5, ">= 3", scaling::Judgement::unusable, "Hardly told apart"}};
    CHECK(verdict_of(m).answer == Answer::cannot_tell);
    CHECK_THAT(verdict_of(m).why,
               Contains("Hardly told apart") && Contains("contrast to noise is 1.5, must be >= 3"));
    CHECK(to_json(m, std::nullopt).at("angle_of_repose").is_null());
    const std::string text = page_of(m);
    CHECK(fault_in_markup(text) == "");
    CHECK(times_in(text, "No angle can be read from this picture") >= 1);
}
