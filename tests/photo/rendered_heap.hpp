// SPDX-License-Identifier: MIT
// Pictures of heaps whose flanks are known: drawn by supersampling, spoilt by light, lens, sensor and JPEG. Knows nothing of how they are measured.
#pragma once

#include "photo/picture.hpp"

#include <cstdint>
#include <string>

namespace rendered {

enum class Ground {
    none,   // the background goes on under the heap
    table,  // of its own tone, from side to side
};

// Lengths in pixels, tones from 0 to 255 as encoded.
struct Scene {
    double left = 35.0, right = 35.0;  // deg, of the flanks between 10 and 90 % of the height
    double height =
        150.0;  // of the cone that the flanks would make; the tip is round above 90 %, the foot runs out below 10 %
    double grain = 0.0;  // diameter; 0: smooth flanks
    double roll = 0.0;   // deg, of the camera: the base line then rises to the right
    std::size_t width = 640, picture_height = 400;
    double base = 310.0;  // y of the base line in the middle of the picture
    double apex = 320.0;  // x
    Ground ground = Ground::none;
    double heap_tone = 90.0, background = 190.0, table = 90.0;
    double texture = 0.0;   // spread of the grains' own tones
    double blur = 0.8;      // standard deviation of the lens and focus
    double gradient = 0.0;  // share of light lost from the left border to the right
    double vignette = 0.0;  // share of light lost in the corners
    double shadow = 0.0;    // how dark the shadow beside the right foot is, 0 to 1
    double noise = 0.0;     // standard deviation
    double salt = 0.0;      // share of pixels that are black or white
    int jpeg = 0;           // quality; 0: not encoded
    std::uint64_t seed = 1;
};

// Drawn, and through JPEG and back where that is asked for.
photo::Picture picture(const Scene&);

std::string png(const photo::Picture&);  // bytes of a file
std::string jpeg(const photo::Picture&, int quality);

// JPEG bytes with an EXIF block that says how the picture lies; `big_endian`: its byte order.
std::string with_orientation(const std::string& jpeg, int orientation, bool big_endian);

// Any two-tone picture: `heap(x, y)` says whether a place is in the heap; 4 x 4 samples a pixel.
template <class Inside>
photo::Picture two_tones(std::size_t width, std::size_t height, Inside inside) {
    photo::Picture p{width, height, {}, 1};
    p.rgb.resize(3 * width * height);
    for (std::size_t j = 0; j < height; ++j)
        for (std::size_t i = 0; i < width; ++i) {
            int count = 0;
            for (int k = 0; k < 16; ++k)
                count += inside(static_cast<double>(i) - 0.375 + 0.25 * (k % 4),
                                static_cast<double>(j) - 0.375 + 0.25 * (k / 4));
            for (std::size_t c = 0; c < 3; ++c)
                p.rgb[3 * (j * width + i) + c] = static_cast<std::uint8_t>(200 - 120 * count / 16);
        }
    return p;
}

}  // namespace rendered
