// SPDX-License-Identifier: MIT
// Where no angle can be read, none is: each refusal by the picture that calls for it.
#include "photo/measure.hpp"
#include "scaling/errors.hpp"
#include "scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>

using namespace rendered;
using Catch::Contains;
using photo::measure;

namespace {

std::string refused(const photo::Picture& p, const photo::Settings& settings = {}) {
    const photo::Measurement m = measure(p, settings);
    if (m.heap) return "measured as " + std::to_string(m.heap->angle / degree);
    REQUIRE(!m.findings.empty());
    CHECK(m.findings.back().judgement == scaling::Judgement::unusable);
    CHECK(!m.findings.back().text.empty());
    return m.findings.back().name;
}

}  // namespace

TEST_CASE("photo refuses: nothing in the picture", "[photo][refusal]") {
    Scene s;
    s.heap_tone = s.background, s.noise = GENERATE(0.0, 8.0);
    const std::string why = refused(picture(s));
    CHECK((why == "contrast_to_noise" || why == "heap_share_of_picture" ||
           why == "background_above"));
}

TEST_CASE("photo refuses: contrast below the noise", "[photo][refusal]") {
    Scene s;
    s.heap_tone = s.background - 8.0, s.noise = 25.0;
    const std::string why = refused(picture(s));
    CHECK((why == "contrast_to_noise" || why == "heap_share_of_picture" ||
           why == "background_above"));
}

TEST_CASE("photo refuses: a heap that the border cuts", "[photo][refusal]") {
    Scene s;
    s.apex = 60.0;
    CHECK(refused(picture(s)) == "foot_in_picture");
    photo::Settings with_base;
    with_base.base = {{10.0, 310.0}, {630.0, 310.0}};
    CHECK(refused(picture(s), with_base) == "cut_by_border");
    s.apex = 320.0, s.base = 120.0;  // no room above
    CHECK(refused(picture(s)) == "background_above");
}

TEST_CASE("photo refuses: too few pixels, too few grains", "[photo][refusal]") {
    Scene s;
    s.height = 38.0;
    CHECK(refused(picture(s)) == "height_in_pixels");
    s.height = 150.0, s.grain = 60.0;
    const std::string why = refused(picture(s));
    CHECK((why == "independent_pieces_of_flank" || why == "roughness_over_height" ||
           why == "flanks_found"));
}

TEST_CASE("photo refuses: shapes that are no heap", "[photo][refusal]") {
    // A disc, and a block with a low roof: neither has two straight flanks.
    CHECK(refused(two_tones(640, 400, [](double x, double y) {
              return std::hypot(x - 320.0, y - 200.0) < 120.0;
          })).substr(0, 8) != "measured");
    CHECK(refused(two_tones(640, 400, [](double x, double y) {
              return std::abs(x - 320.0) < 150.0 && y < 320.0 &&
                     y > 160.0 + 0.2 * std::abs(x - 320.0);
          })).substr(0, 8) != "measured");
}

TEST_CASE("photo: mistakes in what is stated name the place and the remedy", "[photo][refusal]") {
    const photo::Picture p = picture({});
    const auto complaint = [&](const photo::Settings& s) -> std::string {
        try {
            measure(p, s);
        } catch (const scaling::InvalidParameter& e) {
            return e.what();
        }
        return "";
    };
    photo::Settings outside, steep, small, down;
    outside.base = {{10.0, 310.0}, {900.0, 310.0}};
    steep.base = {{310.0, 10.0}, {330.0, 310.0}};
    small.crop = {{10.0, 10.0}, {20.0, 200.0}};
    down.looking_down = 50.0 * degree;
    CHECK_THAT(complaint(outside), Contains("base: got 900,310") && Contains("640 x 400"));
    CHECK_THAT(complaint(steep), Contains("flatter than 45 deg"));
    CHECK_THAT(complaint(small), Contains("crop") && Contains("at least 32"));
    CHECK_THAT(complaint(down), Contains("looking_down: got 50 deg"));
}
