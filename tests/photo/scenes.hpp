// SPDX-License-Identifier: MIT
// What pictures are drawn for the figures of docs/photo.md: chance within the limits written here.
#pragma once

#include "rendered_heap.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace rendered {

constexpr double degree = std::numbers::pi / 180.0;

// A heap of grains under good light: 22 to 55 deg, 15 to 40 grains high, camera rolled by up to 5 deg, on the background's own tone or on a table,
// dark on light or light on dark, some noise, JPEG of telephone quality.
inline Scene good_scene(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> u;
    const auto in = [&](double low, double high) { return low + (high - low) * u(random); };
    Scene s;
    s.left = s.right = in(22.0, 55.0);
    s.height = std::min(230.0, 240.0 * std::tan(s.left * degree)) * in(0.8, 1.0);
    s.grain = s.height / in(15.0, 40.0);
    s.roll = in(-5.0, 5.0);
    s.apex = 320.0 + in(-20.0, 20.0), s.base = 320.0 + in(-15.0, 15.0);
    s.ground = u(random) < 0.5 ? Ground::none : Ground::table;
    const bool lighter = u(random) < 0.5;
    s.heap_tone = lighter ? in(150.0, 210.0) : in(40.0, 90.0),
    s.background = lighter ? in(30.0, 80.0) : in(150.0, 220.0);
    s.table = s.heap_tone + in(-15.0, 15.0);
    s.texture = in(0.0, 12.0), s.blur = in(0.6, 1.5), s.noise = in(1.0, 6.0), s.jpeg = 90;
    s.seed = seed;
    return s;
}

// The same heaps under bad light and with a bad sensor.
inline Scene bad_scene(std::uint64_t seed) {
    Scene s = good_scene(seed);
    std::mt19937_64 random(seed + 1000);
    std::uniform_real_distribution<double> u;
    const auto in = [&](double low, double high) { return low + (high - low) * u(random); };
    const double middle = 0.5 * (s.heap_tone + s.background),
                 half = in(0.35, 0.7) * 0.5 * (s.heap_tone - s.background);
    s.heap_tone = middle + half, s.background = middle - half,
    s.table = s.heap_tone + in(-5.0, 5.0);
    s.texture = in(0.0, 8.0), s.blur = in(0.8, 2.5);
    s.gradient = in(0.2, 0.5), s.vignette = in(0.2, 0.5), s.shadow = in(0.2, 0.6);
    s.noise = in(5.0, 12.0), s.salt = in(0.0, 0.03), s.jpeg = static_cast<int>(in(25.0, 60.0));
    return s;
}

}  // namespace rendered
