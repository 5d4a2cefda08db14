// SPDX-License-Identifier: MIT
// Prints the figures of docs/photo.md; runs only when named: build/test_photo "[table]". With "[draw]" it writes two of the pictures into out/.
#include "photo/measure.hpp"
#include "scenes.hpp"

#include <catch2/catch.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <vector>

using namespace rendered;

namespace {

struct Tally {
    int measured = 0, covered = 0, flank_drawn = 0, flank_covered = 0;
    double sum = 0.0, squares = 0.0, worst = 0.0, width = 0.0, tilt = 0.0;
    std::map<std::string, int> refused;

    void add(const Scene& s) {
        const photo::Measurement m = photo::measure(picture(s), {});
        if (!m.heap) {
            ++refused[m.findings.back().name];
            return;
        }
        const photo::Heaped& h = *m.heap;
        const double truth = 0.5 * (s.left + s.right), error = h.angle / degree - truth;
        ++measured, sum += error, squares += error * error,
            worst = std::max(worst, std::abs(error));
        covered += truth * degree >= h.interval.low && truth * degree <= h.interval.high;
        width += 0.5 * (h.interval.high - h.interval.low) / degree;
        for (const auto& [flank, angle] : {std::pair{h.left, s.left}, std::pair{h.right, s.right}})
            ++flank_drawn, flank_covered += angle * degree >= flank.interval.low &&
                                            angle * degree <= flank.interval.high;
        tilt = std::max(tilt, std::abs(h.tilt / degree - s.roll));
    }
    void print(const std::string& name) const {
        const double n = std::max(1, measured), mean = sum / n;
        std::string why;
        for (const auto& [reason, count] : refused)
            why += fmt::format("{}{} {}", why.empty() ? "" : ", ", count, reason);
        fmt::print(
            "| {} | {:+.2f} | {:.2f} | {:.2f} | {:.2f} | {:.1f} % | {:.1f} % | {:.2f} | {} "
            "|\n",
            name, mean, std::sqrt(std::max(0.0, squares / n - mean * mean)), worst, width / n,
            100.0 * covered / n, 100.0 * flank_covered / std::max(1, flank_drawn), tilt,
            why.empty() ? "none" : why);
        std::fflush(stdout);
    }
};

}  // namespace

TEST_CASE("table: error and coverage on rendered heaps", "[.][table]") {
    SECTION("head") {
        fmt::print(
            "| pictures | bias | scatter | worst | half interval | covered | flanks covered | "
            "worst tilt | refused of 200 |\n");
        fmt::print("|---|---|---|---|---|---|---|---|---|\n");
    }
    // One row alone: build/test_photo "[table]" -c "blur 3 pixels".
    const auto row = [&](const std::string& name, auto change, bool bad = false) {
        DYNAMIC_SECTION(name) {
            Tally t;
            for (std::uint64_t seed = 1001; seed <= 1200; ++seed) {
                Scene s = bad ? bad_scene(seed) : good_scene(seed);
                change(s);
                t.add(s);
            }
            t.print(name);
        }
    };
    row("good light", [](Scene&) {});
    row("noise 25", [](Scene& s) { s.noise = 25.0; });
    row("5 % salt and pepper", [](Scene& s) { s.salt = 0.05; });
    row("gradient and vignette 30 %", [](Scene& s) { s.gradient = s.vignette = 0.3; });
    row("gradient and vignette 60 %", [](Scene& s) { s.gradient = s.vignette = 0.6; });
    row("a quarter of the contrast", [](Scene& s) {
        s.heap_tone = s.background + 0.25 * (s.heap_tone - s.background);
        s.table = s.heap_tone, s.texture *= 0.25;
    });
    row("shadow at a foot", [](Scene& s) { s.shadow = 0.5; });
    row("blur 3 pixels", [](Scene& s) { s.blur = 3.0; });
    row("JPEG quality 15", [](Scene& s) { s.jpeg = 15; });
    row("table of a third tone, between", [](Scene& s) {
        s.ground = Ground::table, s.table = s.heap_tone + 0.6 * (s.background - s.heap_tone);
    });
    row("table of a third tone, beyond", [](Scene& s) {
        s.ground = Ground::table, s.table = s.background + 0.25 * (s.background - s.heap_tone);
    });
    row("flanks 4 deg apart", [](Scene& s) { s.left -= 2.0, s.right += 2.0; });
    row(
        "all of it, milder", [](Scene&) {}, true);
}

TEST_CASE("table: pictures to try the program on", "[.][draw]") {
    std::filesystem::create_directories("out");
    for (const bool bad : {false, true}) {
        const Scene s = bad ? bad_scene(8) : good_scene(4);
        const std::string path = bad ? "out/heap-bad-light.jpg" : "out/heap.jpg";
        std::ofstream(path, std::ios::binary) << jpeg(picture(s), 92);
        fmt::print("{}: {:.1f} deg, camera rolled by {:.1f} deg\n", path, s.left, s.roll);
    }
}
