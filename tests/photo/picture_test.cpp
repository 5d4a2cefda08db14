// SPDX-License-Identifier: MIT
#include "photo/picture.hpp"

#include "rendered_heap.hpp"
#include "scaling/errors.hpp"

#include <catch2/catch.hpp>

#include <cstdlib>
#include <string>

using Catch::Contains;

namespace {

// Four quarters of their own tones: top left 0, top right 80, bottom left 160, bottom right 240; wider than high.
photo::Picture quarters() {
    photo::Picture p{64, 32, {}, 1};
    for (std::size_t y = 0; y < 32; ++y)
        for (std::size_t x = 0; x < 64; ++x)
            for (int c = 0; c < 3; ++c)
                p.rgb.push_back(static_cast<std::uint8_t>((y < 16 ? 0 : 160) + (x < 32 ? 0 : 80)));
    return p;
}

// The tones of the four quarters as they are seen, in the order above.
std::string seen(const photo::Picture& p) {
    std::string text = p.width > p.height ? "wide" : "high";
    for (const std::size_t k : {0u, 1u, 2u, 3u}) {
        const std::size_t x = (k % 2) * p.width / 2 + p.width / 4,
                          y = (k / 2) * p.height / 2 + p.height / 4;
        text += " " + std::to_string((p.rgb[3 * (y * p.width + x)] + 40) / 80);
    }
    return text;
}

}  // namespace

TEST_CASE("picture: PNG as it is, JPEG nearly so", "[photo][picture]") {
    const photo::Picture p = quarters();
    const photo::Picture read = photo::decode(rendered::png(p), "x");
    CHECK(read.width == 64);
    CHECK(read.height == 32);
    CHECK(read.rgb == p.rgb);
    CHECK(seen(photo::decode(rendered::jpeg(p, 90), "x")) == "wide 0 1 2 3");
    CHECK(seen(photo::decode(photo::jpeg_of(p), "x")) == "wide 0 1 2 3");
}

// By hand from EXIF 2.3, table of tag Orientation: where row 0 and column 0 of the file are seen. 2: top, right; 3: bottom, right; 4: bottom, left; 5: left,
// top; 6: right, top; 7: right, bottom; 8: left, bottom. E.g. 6: the file's first row is the right side, its first column the top.
TEST_CASE("picture: turned as EXIF says, all eight ways, both byte orders", "[photo][picture]") {
    const char* expected[] = {"wide 0 1 2 3", "wide 1 0 3 2", "wide 3 2 1 0", "wide 2 3 0 1",
                              "high 0 2 1 3", "high 2 0 3 1", "high 3 1 2 0", "high 1 3 0 2"};
    const std::string file = rendered::jpeg(quarters(), 90);
    for (int orientation = 1; orientation <= 8; ++orientation)
        for (const bool big_endian : {false, true}) {
            INFO(orientation);
            CHECK(seen(photo::decode(rendered::with_orientation(file, orientation, big_endian),
                                     "x")) == expected[orientation - 1]);
        }
    CHECK(seen(photo::decode(rendered::with_orientation(file, 9, true), "x")) == expected[0]);
}

TEST_CASE("picture: reduced by a whole number to means, places kept", "[photo][picture]") {
    const photo::Picture small = photo::decode(rendered::png(quarters()), "x", 20);
    CHECK(small.reduced_by == 4);
    CHECK(small.width == 16);
    CHECK(small.height == 8);
    CHECK(seen(small) == "wide 0 1 2 3");
    CHECK(small.in_file({0.0, 1.0}).x == Approx(1.5));  // the middle of pixels 0 to 3
    CHECK(small.in_file({0.0, 1.0}).y == Approx(5.5));
    CHECK(small.in_rgb(small.in_file({3.0, 2.0})).x == Approx(3.0));
}

TEST_CASE("picture: what is no picture is refused, damaged ones too", "[photo][picture][input]") {
    const auto complaint = [](const std::string& bytes) -> std::string {
        try {
            photo::decode(bytes, "heap.jpg");
        } catch (const scaling::InvalidInput& e) {
            return e.what();
        }
        return "";
    };
    CHECK_THAT(complaint("no picture at all"),
               Contains("heap.jpg: got a file that is no picture") && Contains("HEIC"));
    CHECK_THAT(complaint(""), Contains("must be PNG or JPEG"));
    const std::string png = rendered::png(quarters());
    CHECK_THAT(complaint(png.substr(0, png.size() / 2)), Contains("damaged"));
    CHECK_THROWS_WITH(photo::read_picture("no/such/file.png"), Contains("no/such/file.png"));
    // Cut off anywhere, a JPEG gives a picture or a message, nothing else.
    const std::string jpeg = rendered::with_orientation(rendered::jpeg(quarters(), 50), 6, true);
    for (std::size_t size = 0; size < jpeg.size(); size += 3) complaint(jpeg.substr(0, size));
}
